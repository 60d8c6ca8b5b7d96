//! A finger on the beam to play with: every handle follows it up and down, and the page stays where it is.
//!
//! Events that a script of the page makes do not show whether the browser takes a touch for scrolling. These are made by the browser.

use crate::devtools::Page;

/// Handles of the beam: seven points of the ground, and the load.
const HANDLES: usize = 8;
/// How far the finger moves \[px\]: three times of what a browser takes for a tap.
const WAY: f64 = 48.0;
/// In so many steps.
const STEPS: u32 = 8;
/// How far a handle may be from the finger in the end \[px\].
const NEAR: f64 = 3.0;
/// The style with which the finger scrolled the page: the check has to notice it.
const SCROLLS: &str = "pan-y";

/// Tries the page at this address on a telephone; says how many handles follow.
pub(crate) fn tried(page: &mut Page, address: &str) -> Result<String, String> {
    page.ask(
        "Emulation.setDeviceMetricsOverride",
        "\"width\":390,\"height\":844,\"deviceScaleFactor\":1,\"mobile\":true",
    )?;
    page.ask("Emulation.setTouchEmulationEnabled", "\"enabled\":true")?;
    page.ask("Page.navigate", &format!("\"url\":\"{address}\""))?;
    page.until("document.readyState === 'complete' && document.querySelectorAll('#play circle').length === 8")?;
    let following = dragged(page, "")?;
    if following != HANDLES {
        return Err(format!("{following} of {HANDLES} handles of the beam follow a finger"));
    }
    let with_scrolling = dragged(page, SCROLLS)?;
    if with_scrolling != 0 {
        return Err(format!(
            "{with_scrolling} handles seem to follow a finger that scrolls the page: the check sees nothing"
        ));
    }
    Ok(format!("{following} of {HANDLES} handles follow a finger, and none with the style `{SCROLLS}`"))
}

/// How many handles follow a finger that moves down, if the drawing has this style.
fn dragged(page: &mut Page, style: &str) -> Result<usize, String> {
    let mut following = 0;
    for handle in 0..HANDLES {
        let place = format!(
            "(({{ x, y, width, height }}) => [x + width / 2, y + height / 2, scrollY])(handles.children[{handle}].getBoundingClientRect())"
        );
        page.numbers(&format!(
            "[svg.style.touchAction = '{style}', begin(), frame(), section.scrollIntoView({{ block: 'start', behavior: 'instant' }})]\
             .slice(4)"
        ))?;
        let [x, y, scrolled] = page.numbers(&place)?[..] else { return Err(format!("handle {handle} has no place")) };
        touch(page, "touchStart", Some((x, y)))?;
        for step in 1..=STEPS {
            touch(page, "touchMove", Some((x, y + WAY * f64::from(step) / f64::from(STEPS))))?;
        }
        touch(page, "touchEnd", None)?;
        page.numbers("[frame()].slice(1)")?;
        let [_, to, later] = page.numbers(&place)?[..] else { return Err(format!("handle {handle} has no place")) };
        // The load ends where it has no force.
        let is_load = handle + 1 == HANDLES;
        let follows = if is_load { y + NEAR < to } else { (to - y - WAY).abs() < NEAR };
        following += usize::from(follows && (later - scrolled).abs() < 1.0);
    }
    Ok(following)
}

fn touch(page: &mut Page, kind: &str, at: Option<(f64, f64)>) -> Result<(), String> {
    let points = at.map_or_else(String::new, |(x, y)| format!("{{\"x\":{x},\"y\":{y}}}"));
    page.ask("Input.dispatchTouchEvent", &format!("\"type\":\"{kind}\",\"touchPoints\":[{points}]")).map(|_| ())
}
