//! Reasons in sentences.

use super::evidence::Basis;
use super::{GOVERNS, JointMode, MAY_SHIFT, ModeCall, PARTS, SEVERED, Why};

/// How near the damage is to that of other modes.
pub(super) struct Reserve {
    /// Other modes that the rules would call.
    pub(super) near: Vec<JointMode>,
    /// Where the share alone counts: that part of the damage, and the other modes that hold it or more.
    pub(super) part: Option<(f64, Vec<JointMode>)>,
    pub(super) without: Without,
}

/// What else of the damage was left out to see what the rules would call.
#[derive(Default)]
pub(super) struct Without {
    /// All that failed in the collapse.
    pub(super) collapse: bool,
    /// Of that, what it covers of the paths.
    pub(super) its_ways: bool,
}

/// What was seen, what it is called for and what limits the trust in it, in the order in which a reader wants it.
pub(super) fn of(
    call: &ModeCall,
    basis: Basis,
    why: Why,
    reserve: &Reserve,
    retained: Option<f64>,
) -> Vec<String> {
    let mut reasons = vec![seen(call, basis)];
    if call.collapse > 0.0 {
        let collapse = percent(call.collapse);
        reasons.push(format!(
            "{collapse:.0} % of it failed in the collapse, the increment beyond the last equilibrium; files and figures of damage end at that \
             equilibrium"
        ));
    }
    reasons.push(ground(call, why));
    reasons.push(reserve.sentence());
    reasons.extend(retained.map(|retained| load_kept(call, retained)));
    reasons
}

fn percent(part: f64) -> f64 {
    100.0 * part
}

/// What damage there is, and where.
fn seen(call: &ModeCall, basis: Basis) -> String {
    let what = if basis.fibre {
        "broken fibres"
    } else {
        "matrix damage"
    };
    let when = if basis.late {
        "from 95 % of the peak load on, to the end of the history"
    } else {
        "in the whole history, because nothing failed late"
    };
    let [bearing, shear, tension] = call.shares.map(percent);
    let rest = percent(1.0 - call.shares.iter().sum::<f64>());
    let elsewhere = if rest >= 0.5 {
        format!(", {rest:.0} % elsewhere")
    } else {
        String::new()
    };
    format!(
        "{what} {when}: {bearing:.0} % ahead of the pin (0–35°), {shear:.0} % where a plug shears out (45–80°), {tension:.0} % at the \
         net section (about 90°){elsewhere}"
    )
}

/// What the mode is called for.
fn ground(call: &ModeCall, why: Why) -> String {
    let [ahead, plug, ligament] = call.reach.map(percent);
    let (parted, governs) = (percent(SEVERED), percent(GOVERNS));
    let before = |way: usize| {
        if call.collapse > 0.0 {
            let followed = percent(call.followed_reach[way]);
            format!("{followed:.0} % at the last equilibrium; ")
        } else {
            String::new()
        }
    };
    match (why, call.mode) {
        (Why::Severed, JointMode::NetTension) => format!(
            "broken material covers {ligament:.0} % of the way from the hole to the side ({}{parted:.0} % part the net section), and {plug:.0} % of \
             that to the end",
            before(2)
        ),
        (Why::Severed, _) => format!(
            "broken material covers {plug:.0} % of the way from the hole to the end ({}{parted:.0} % free the plug), and {ligament:.0} % of that to \
             the side",
            before(1)
        ),
        (Why::Split, _) => format!(
            "the end is split ahead of the pin, over {ahead:.0} % of the way to it ({}{parted:.0} % part it), and {ligament:.0} % of the way to the \
             side are broken",
            before(0)
        ),
        (Why::Share, mode) => format!(
            "most of it lies where {mode} begins ({governs:.0} % decide); neither path to side or end is alone severed"
        ),
        (Why::Confined, _) => format!(
            "it stays at the hole's edge, over {ligament:.0} % of the way to the side and {plug:.0} % of that to the end, and the largest part lies \
             ahead of the pin"
        ),
        (Why::NoShare, _) => format!(
            "no mode has {governs:.0} % of it, and neither path to side or end is alone severed"
        ),
    }
}

/// What is left of the load behind its peak.
fn load_kept(call: &ModeCall, retained: f64) -> String {
    let kept = percent(retained);
    if retained < 0.7 {
        format!("the load falls to {kept:.0} % of its peak: the path that bore it is lost")
    } else if call.mode == JointMode::Bearing {
        format!("the load stays at {kept:.0} % of its peak: the pin goes on crushing material")
    } else {
        format!("the load stays at {kept:.0} % of its peak as far as the history goes")
    }
}

impl Reserve {
    fn sentence(&self) -> String {
        let without = match (self.without.collapse, self.without.its_ways) {
            (true, true) => ", or without the collapse or the ways that it broke",
            (true, false) => ", or without the collapse",
            (false, true) => ", or without the ways that the collapse broke",
            (false, false) => "",
        };
        let changes = format!(
            "if {:.0} % of it lay elsewhere, broken material covered {:.0} % more or less of a way, or both{without}",
            100.0 * MAY_SHIFT,
            100.0 / PARTS as f64
        );
        let names = |modes: &[JointMode], and: &str| -> String {
            let names: Vec<&str> = modes.iter().map(|mode| mode.name()).collect();
            names.join(and)
        };
        let near = match &self.near[..] {
            [] => format!("no other mode would be called {changes}"),
            near => format!("near to {}, {changes}", names(near, " or ")),
        };
        let part = match &self.part {
            Some((least, modes)) if !modes.is_empty() => {
                let holds = if modes.len() == 1 {
                    "holds"
                } else {
                    "each hold"
                };
                let (modes, least) = (names(modes, " and "), 100.0 * least);
                format!("; {modes} {holds} {least:.0} % of it or more")
            }
            _ => String::new(),
        };
        format!("{near}{part}; another mesh or control can lead to yet another one")
    }
}
