//! The command `export`: the quadratic program of a beam on a grid, for other solvers, whose answer `certify` can read.

use std::fmt::Write as _;
use std::path::PathBuf;

use palkki::methods::{Discrete, unsigned};
use palkki::qp::{Qp, SparseForm, UpperColumns};
use palkki::route::Method;

use super::Outcome;
use super::arguments::{Export, Form};
use super::input::Input;
use super::output::Failure;
use super::qps::qps;

/// Most unknowns of a full matrix as text: 4000 need some 200 MB.
const LARGEST_DENSE: usize = 4000;

impl Export {
    /// The names of the files, in the order in which they are made.
    fn names(&self) -> &'static [&'static str] {
        match (self.form, self.method.0.is_free_in_contact()) {
            (Form::Qps, _) => &["program.mps", "names.csv"],
            (Form::Sparse, _) => &["P.mtx", "q.csv", "A.mtx", "bounds.csv", "names.csv"],
            (Form::Dense, true) => &["body.toml", "C.mtx", "gap.csv", "names.csv"],
            (Form::Dense, false) => &["body.toml", "K.mtx", "load.csv", "names.csv"],
        }
    }

    /// The paths of the files.
    pub(super) fn places(&self) -> Vec<Option<PathBuf>> {
        self.names().iter().map(|name| Some(self.to.join(name))).collect()
    }
}

/// Writes the program of a beam as files.
pub(super) fn export<'a>(
    input: &Input,
    arguments: &Export,
    places: &'a [Option<PathBuf>],
) -> Result<Outcome<'a>, Failure> {
    let Export { method, intervals, form, .. } = arguments;
    let method = method.0;
    if !input.scene.has_obstacle() {
        return Err(Failure::refused("export", "without a foundation there is no quadratic program"));
    }
    let discrete = Discrete::new(&input.scene, *intervals).map_err(|error| input.error(error))?;
    let qp = method.qp(&discrete);
    let names = (0..qp.dimension()).map(|k| unknown_name(&discrete, method, k));
    let texts = match form {
        Form::Dense => {
            let names = names.map(|name| [name]);
            let [scene, matrix, linear] = dense(input, method, &discrete, qp.as_ref())?;
            vec![scene, matrix, linear, csv("i,what", names)]
        }
        Form::Sparse | Form::Qps => {
            let Some(sparse_form) = qp.sparse() else {
                return Err(Failure::refused("export", "there is no sparse form"));
            };
            let free = unsigned(&discrete, method).into_iter().take(sparse_form.signed);
            let (what, units): (Vec<String>, Vec<f64>) =
                free.chain(names.map(|name| (name, sparse_form.sizes.x))).unzip();
            if *form == Form::Qps {
                let energy = discrete.sizes().x * discrete.sizes().gradient;
                vec![qps(&sparse_form, &units, energy), csv("i,what", what.into_iter().map(|name| [name]))]
            } else {
                let names = what.into_iter().zip(units).map(|(name, unit)| [format!("{name} in units of {unit:?}")]);
                let mut texts = sparse(&sparse_form);
                texts.push(csv("i,what", names));
                texts
            }
        }
    };
    let shown = arguments.common.shown(
        || format!("{} unknowns in {}\n", qp.dimension(), arguments.to.display()),
        || super::json::print(&serde_json::json!({ "scene": input.title(), "files": arguments.names() })),
    );
    let files = places.iter().flatten().zip(texts).map(Some).collect();
    Ok(Outcome { text: shown, files, is_certified: true })
}

/// What an unknown of the program is.
fn unknown_name(discrete: &Discrete, method: Method, k: usize) -> String {
    let (node, is_stop, give) = discrete.unknown(k);
    let of = if is_stop { " of the support" } else { "" };
    let place = discrete.grid.place(node);
    match method.is_free_in_contact() {
        true if is_stop => format!("force{of} at x = {place:?}"),
        true => format!("contact force at x = {place:?}"),
        // For an elastic support or foundation, the program's variable is the clearance of the unloaded spring.
        false if is_stop => {
            format!("clearance of the beam above the support at x = {place:?} plus {give:?} times its force")
        }
        false if 0.0 < give => {
            format!("clearance of the beam at x = {place:?} plus {give:?} times the contact force there")
        }
        false => format!("clearance at x = {place:?}"),
    }
}

/// A scene file with a body, its matrix, and its gaps or loads. Gaps and loads are `−b`. For finite differences, whose gradient is a
/// pressure, matrix and loads are multiplied by the spacing.
fn dense(input: &Input, method: Method, discrete: &Discrete, qp: &dyn Qp) -> Result<[String; 3], Failure> {
    let n = qp.dimension();
    if let Some(why) = qp.without_matrix() {
        return Err(Failure::refused("export", format!("{why}; --form sparse has one")));
    }
    if !discrete.is_held() {
        let message = "the supports leave the beam free to move as a whole, so that its stiffness matrix is singular; --form sparse has what the loads have to balance";
        return Err(Failure::refused("export", message));
    }
    if LARGEST_DENSE < n {
        let message = format!("a full matrix of {n} unknowns is more than {LARGEST_DENSE}; take --form sparse");
        return Err(Failure::refused("export", message));
    }
    let (matrix, share) = (qp.matrix(), method.share(discrete));
    let entries = (0..n).flat_map(|j| (j..n).map(move |i| (i, j)));
    let entries = entries.map(|(i, j)| (i, j, matrix.entry(i, j) * share)).filter(|entry| entry.2 != 0.0);
    let quoted = |text: &str| format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""));
    let title = quoted(&format!("{}, {method} method, {} intervals", input.title(), discrete.intervals));
    let (keys, quantity) = if method.is_free_in_contact() {
        ("flexibility = \"C.mtx\"\ngap = \"gap.csv\"", "i,gap")
    } else {
        ("stiffness = \"K.mtx\"\nload = \"load.csv\"", "i,force")
    };
    let mut scene = format!("title = {title}\n\n[body]\n{keys}\n");
    let units = input.scene.units();
    let labels = [("length", &units.length), ("force", &units.force)];
    if labels.iter().any(|(_, label)| label.is_some()) {
        scene += "\n[units]\n";
        for (key, label) in labels.iter().filter_map(|(key, label)| Some((key, label.as_ref()?))) {
            let _ = writeln!(scene, "{key} = {}", quoted(label));
        }
    }
    let linear = csv(quantity, qp.linear().iter().map(|b| [format!("{:?}", -b * share)]));
    Ok([scene, matrix_market([n, n], "symmetric", &entries.collect::<Vec<_>>()), linear])
}

/// The files of `P`, `q`, `A` and the bounds: minimise `½ xᵀ P x + qᵀ x` subject to `lower ≤ A x ≤ upper`.
fn sparse(form: &SparseForm) -> Vec<String> {
    let m = form.linear.len();
    let n = m - form.signed;
    let by_columns = |starts: &[usize], rows: &[usize], values: &[f64]| -> Vec<(usize, usize, f64)> {
        let columns = starts.windows(2).enumerate().flat_map(|(j, range)| (range[0]..range[1]).map(move |k| (j, k)));
        columns.map(|(j, k)| (rows[k], j, values[k])).collect()
    };
    let UpperColumns { starts, rows, values } = &form.quadratic;
    let quadratic: Vec<_> = by_columns(starts, rows, values).into_iter().map(|(i, j, a)| (j, i, a)).collect();
    let (starts, rows, values) = form.constraints(1.0);
    let equations = form.right.iter().map(|e| [format!("{e:?}"), format!("{e:?}")]);
    let signs = (0..n).map(|_| ["0.0".to_owned(), "inf".to_owned()]);
    vec![
        matrix_market([m, m], "symmetric", &quadratic),
        csv("i,q", form.linear.iter().map(|q| [format!("{q:?}")])),
        matrix_market([form.right.len() + n, m], "general", &by_columns(&starts, &rows, &values)),
        csv("i,lower,upper", equations.chain(signs)),
    ]
}

fn matrix_market([rows, columns]: [usize; 2], kind: &str, entries: &[(usize, usize, f64)]) -> String {
    let mut text = format!("%%MatrixMarket matrix coordinate real {kind}\n{rows} {columns} {}\n", entries.len());
    for (i, j, a) in entries {
        // Writing to a string does not fail.
        let _ = writeln!(text, "{} {} {a:?}", i + 1, j + 1);
    }
    text
}

/// CSV rows that begin with their number.
fn csv<const N: usize>(header: &str, rows: impl Iterator<Item = [String; N]>) -> String {
    (1..).zip(rows).fold(format!("{header}\n"), |text, (i, row)| text + &format!("{i},{}\n", row.join(",")))
}
