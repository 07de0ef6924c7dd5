//! Reasons in sentences.

use super::{Basis, GOVERNS, JointMode, MAY_SHIFT, ModeCall, PARTS, SEVERED, Why};

pub(super) fn of(call: &ModeCall, basis: Basis, why: Why, retained: Option<f64>) -> Vec<String> {
    let percent = |part: f64| 100.0 * part;
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
    let mut reasons = vec![format!(
        "{what} {when}: {bearing:.0} % ahead of the pin (0–35°), {shear:.0} % where a plug shears out (45–80°), {tension:.0} % at the \
         net section (about 90°){elsewhere}"
    )];
    if call.collapse > 0.0 {
        let collapse = percent(call.collapse);
        reasons.push(format!(
            "{collapse:.0} % of it failed in the collapse, the increment beyond the last equilibrium; files and figures of damage end at that \
             equilibrium"
        ));
    }
    let [ahead, plug, ligament] = call.reach.map(percent);
    let parted = percent(SEVERED);
    let before = |mode: usize| {
        if call.collapse > 0.0 {
            let followed = percent(call.followed_reach[mode]);
            format!("{followed:.0} % at the last equilibrium; ")
        } else {
            String::new()
        }
    };
    reasons.push(match (why, call.mode) {
        (Why::Severed, JointMode::NetTension) => format!(
            "broken material covers {ligament:.0} % of the way from the hole to the side ({}{parted:.0} % part the net section), and {plug:.0} % of \
             that to the end", before(2)
        ),
        (Why::Severed, _) => format!(
            "broken material covers {plug:.0} % of the way from the hole to the end ({}{parted:.0} % free the plug), and {ligament:.0} % of that to \
             the side", before(1)
        ),
        (Why::Split, _) => format!(
            "the end is split ahead of the pin, over {ahead:.0} % of the way to it ({}{parted:.0} % part it), and {ligament:.0} % of the way to the \
             side are broken", before(0)
        ),
        (Why::Share, mode) => format!(
            "most of it lies where {mode} begins ({:.0} % decide); neither path to side or end is alone severed",
            percent(GOVERNS)
        ),
        (Why::Confined, _) => format!(
            "it stays at the hole's edge, over {ligament:.0} % of the way to the side and {plug:.0} % of that to the end, and the largest part lies \
             ahead of the pin"
        ),
        (Why::NoShare, _) => {
            let governs = percent(GOVERNS);
            format!("no mode has {governs:.0} % of it, and neither path to side or end is alone severed")
        }
    });
    reasons.push(reserve(call));
    if let Some(retained) = retained {
        let kept = percent(retained);
        reasons.push(if retained < 0.7 {
            format!("the load falls to {kept:.0} % of its peak: the path that bore it is lost")
        } else if call.mode == JointMode::Bearing {
            format!("the load stays at {kept:.0} % of its peak: the pin goes on crushing material")
        } else {
            format!("the load stays at {kept:.0} % of its peak as far as the history goes")
        });
    }
    reasons
}

/// How near the damage is to that of other modes.
fn reserve(call: &ModeCall) -> String {
    let collapse = if call.collapse > 0.0 {
        ", or if the collapse went another way"
    } else {
        ""
    };
    let changes = format!(
        "if {:.0} % of it lay elsewhere and broken material covered {:.0} % more or less of a way{collapse}",
        100.0 * MAY_SHIFT,
        100.0 / PARTS as f64
    );
    let others: Vec<&str> = call.others.iter().map(|mode| mode.name()).collect();
    let near = match &others[..] {
        [] => format!("no other mode would be called {changes}"),
        others => format!("near to {}, {changes}", others.join(" or ")),
    };
    format!("{near}; another mesh or control can lead to yet another one")
}
