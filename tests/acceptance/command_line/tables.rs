//! Tables, as a person reads them.

use palkki::route::{Method, Solver};

use super::{Folder, RIDGE};

/// A table without what changes from run to run and from processor to processor.
fn steady(text: &str) -> String {
    let shaky = ["  seconds", "  status", "  what remains", "  iterations"];
    let lines = text.lines().filter(|line| !shaky.iter().any(|start| line.starts_with(start)));
    lines.collect::<Vec<_>>().join("\n")
}

/// Four intervals with contact at all three nodes, to be checked by hand: `p_1 = q − 2 EI u / Δ⁴`, `p_2 = q + 2 EI u / Δ⁴`.
#[test]
fn table_of_solve() {
    let folder = Folder::new("table");
    let run = folder.run("solve example.toml --method complementarity --intervals 4 --nodes");
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""), "so few intervals are certain to 28 % only");
    insta::assert_snapshot!(steady(&run.out), @"
    Example
    =======

      beam        length 10, bending stiffness 1.302083333
      load        uniform 1
      foundation  flat, depth 1

      method      complementarity, 4 intervals
      solver      active-set, which says: optimal
      regime      zone
      unknowns    3

    Equilibrium
                           force
      loads                   10  down
      left support   1.333333333  up
      right support  1.333333333  up
      contact        7.333333333  up

    Contacts
            from   to        force
      zone   2.5  7.5  7.333333333

    Extremes
                                 value   at
      largest deflection             1    5
      least deflection               0    0
      largest moment      0.2083333333  2.5
      least moment                   0    0
      energy J            -7.416666667

    Guaranteed for the continuous beam
                                   at least       at most
      energy J*                -8.108516782  -8.108516781
      left reaction             1.182177011   1.182177012
      right reaction            1.182177011   1.182177012
      stiffness D               6.166355863   6.166355864
      error of the deflection                      2.8e-1

    Nodes
      node    x  deflection  clearance  contact force        moment
         1  2.5           1          0    2.333333333  0.2083333333
         2    5           1          0    2.666666667             0
         3  7.5           1          0    2.333333333  0.2083333333
    ");
}

#[test]
fn table_with_units_and_without_contact() {
    let folder = Folder::new("table_units");
    folder.write("high.toml", RIDGE.replace("uniform = 1", "uniform = 0.001"));
    let run = folder.run("solve high.toml --method force --intervals 2");
    assert_eq!((run.code, run.err.as_str()), (Some(1), ""), "two intervals are not certain to a tenth");
    insta::assert_snapshot!(steady(&run.out), @"
    high.toml
    =========

      beam        length 10 m, bending stiffness 1.302083333 kN m²
      load        uniform 0.001 kN/m
      foundation  polyline of 5 points, depths from 0.5 to 1 m

      method      force, 2 intervals
      solver      active-set, which says: optimal
      regime      none
      unknowns    1

    Equilibrium
                     force [kN]
      loads                0.01  down
      left support        0.005  up
      right support       0.005  up
      contact                 0  up

    Contacts: none

    Extremes
                                value  at [m]
      largest deflection [m]     0.08       5
      least deflection [m]          0       0
      largest moment [kN m]    0.0125       5
      least moment [kN m]           0       0
      energy J [kN m]         -0.0002

    Guaranteed for the continuous beam
                                           at least           at most
      energy J* [kN m]             -0.0003200000001  -0.0003199999999
      left reaction [kN]             0.004999999999    0.005000000001
      right reaction [kN]            0.004999999999    0.005000000001
      stiffness D [kN/m]               0.1562499999      0.1562500001
      error of the deflection [m]                              2.1e-2
    ");
}

/// A route that would cost too much on a fine grid has a row, and the reason stands below the table. On level ground at the
/// level of the supports the routes that are tried end soon.
#[test]
fn compare_says_what_it_leaves_out() {
    let folder = Folder::new("left_out");
    let level = "beam = { length = 10, bending_stiffness = 1 }\nload = { uniform = 1 }\nfoundation = { depth = 0 }\n";
    folder.write("level.toml", level);
    let [tried, fine] = [2000, 2001].map(|n| folder.run(&format!("compare level.toml --intervals {n}")));
    let reasons = |out: &str| out.lines().filter(|line| line.contains("not tried: 2001 intervals, 2000 is")).count();
    let told = [reasons(&tried.out), tried.out.matches("in a comparison").count()];
    assert_eq!((tried.code, told), (Some(0), [0; 2]), "{}", tried.out);
    // Two solvers by three methods.
    assert_eq!((fine.code, reasons(&fine.out)), (Some(0), 6), "{}", fine.out);
    let rows = fine.out.lines().filter(|line| line.contains("not-converged")).count();
    assert!(6 <= rows, "{}", fine.out);
}

#[test]
fn table_of_compare_has_a_row_for_each_route() {
    let run = Folder::new("table_compare").run("compare example.toml --intervals 6");
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    for method in Method::ALL {
        for solver in Solver::ALL {
            let rows =
                run.out.lines().filter(|line| line.split_whitespace().take(2).eq([method.name(), solver.name()]));
            assert_eq!(rows.count(), 1, "{method} × {solver} in\n{}", run.out);
        }
    }
}
