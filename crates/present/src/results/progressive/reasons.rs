//! Why a joint's damage is called a mode, in sentences.

use stickslip_joint::{JointMode, ModeCall, ModeRule, Reserve};

/// What was seen, what it is called for and what limits the trust in it, in the order in which a reader wants it.
pub(super) fn reasons(call: &ModeCall) -> Vec<String> {
    let mut reasons = vec![seen(call)];
    if call.collapse > 0.0 {
        let collapse = percent(call.collapse);
        reasons.push(format!(
            "{collapse:.0} % of it failed in the collapse, the increment beyond the last equilibrium; files and figures of damage end at that \
             equilibrium"
        ));
    }
    reasons.push(ground(call));
    reasons.push(margin(&call.reserve));
    reasons.extend(call.retained.map(|retained| load_kept(call, retained)));
    reasons
}

fn percent(part: f64) -> f64 {
    100.0 * part
}

/// What damage there is, and where.
fn seen(call: &ModeCall) -> String {
    let what = if call.basis.fibre {
        "broken fibres"
    } else {
        "matrix damage"
    };
    let when = if call.basis.late {
        format!(
            "from {:.0} % of the peak load on, to the end of the history",
            percent(ModeCall::LATE)
        )
    } else {
        "in the whole history, because nothing failed late".to_owned()
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
fn ground(call: &ModeCall) -> String {
    let [ahead, plug, ligament] = call.reach.map(percent);
    let (parted, governs) = (percent(ModeCall::SEVERED), percent(ModeCall::GOVERNS));
    let before = |way: usize| {
        if call.collapse > 0.0 {
            let followed = percent(call.followed_reach[way]);
            format!("{followed:.0} % at the last equilibrium; ")
        } else {
            String::new()
        }
    };
    match (call.rule, call.mode) {
        (ModeRule::Severed, JointMode::NetTension) => format!(
            "broken material covers {ligament:.0} % of the way from the hole to the side ({}{parted:.0} % part the net section), and {plug:.0} % of \
             that to the end",
            before(2)
        ),
        (ModeRule::Severed, _) => format!(
            "broken material covers {plug:.0} % of the way from the hole to the end ({}{parted:.0} % free the plug), and {ligament:.0} % of that to \
             the side",
            before(1)
        ),
        (ModeRule::Split, _) => format!(
            "the end is split ahead of the pin, over {ahead:.0} % of the way to it ({}{parted:.0} % part it), and {ligament:.0} % of the way to the \
             side are broken",
            before(0)
        ),
        (ModeRule::Share, mode) => format!(
            "most of it lies where {mode} begins ({governs:.0} % decide); neither path to side or end is alone severed"
        ),
        (ModeRule::Confined, _) => format!(
            "it stays at the hole's edge, over {ligament:.0} % of the way to the side and {plug:.0} % of that to the end, and the largest part lies \
             ahead of the pin"
        ),
        (ModeRule::NoShare, _) => format!(
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

/// How near other modes are.
fn margin(reserve: &Reserve) -> String {
    let without = match (reserve.without_collapse, reserve.without_its_paths) {
        (true, true) => ", or without the collapse or the ways that it broke",
        (true, false) => ", or without the collapse",
        (false, true) => ", or without the ways that the collapse broke",
        (false, false) => "",
    };
    let changes = format!(
        "if {:.0} % of it lay elsewhere, broken material covered {:.0} % more or less of a way, or both{without}",
        percent(ModeCall::MAY_SHIFT),
        100.0 / ModeCall::PARTS as f64
    );
    let names = |modes: &[JointMode], and: &str| -> String {
        let names: Vec<&str> = modes.iter().map(|mode| mode.name()).collect();
        names.join(and)
    };
    let near = match &reserve.near[..] {
        [] => format!("no other mode would be called {changes}"),
        near => format!("near to {}, {changes}", names(near, " or ")),
    };
    let part = match &reserve.part {
        Some((least, modes)) if !modes.is_empty() => {
            let holds = if modes.len() == 1 {
                "holds"
            } else {
                "each hold"
            };
            let (modes, least) = (names(modes, " and "), percent(*least));
            format!("; {modes} {holds} {least:.0} % of it or more")
        }
        _ => String::new(),
    };
    format!("{near}{part}; another mesh or control can lead to yet another one")
}

#[cfg(test)]
mod tests {
    use stickslip_joint::Basis;

    use super::*;

    fn call(rule: ModeRule) -> ModeCall {
        ModeCall {
            mode: JointMode::NetTension,
            basis: Basis {
                fibre: true,
                late: true,
            },
            rule,
            shares: [0.1, 0.2, 0.6],
            reach: [0.2, 0.4, 1.0],
            followed_reach: [0.2, 0.2, 0.4],
            collapse: 0.64,
            others: vec![JointMode::ShearOut],
            reserve: Reserve {
                near: vec![JointMode::ShearOut],
                part: Some((0.1, vec![JointMode::Bearing, JointMode::ShearOut])),
                without_collapse: true,
                without_its_paths: true,
            },
            retained: Some(0.3),
        }
    }

    #[test]
    fn every_reason_has_its_numbers() {
        let severed = reasons(&call(ModeRule::Severed));
        let expected: [&[&str]; 5] = [
            &[
                "from 95 % of the peak load on",
                "10 % ahead of the pin (0–35°)",
                "20 % where a plug",
                "(45–80°)",
                "60 % at the net section (about 90°)",
                "10 % elsewhere",
            ],
            &["64 % of it failed in the collapse"],
            &[
                "100 % of the way from the hole",
                "(40 % at the last equilibrium; 80 % part",
                "40 % of that to the end",
            ],
            &[
                "near to shear-out, if 10 % of it",
                "20 % more or less of a way",
                "without the collapse or the ways",
                "bearing and shear-out each hold 10 %",
            ],
            &["30 % of its peak", "is lost"],
        ];
        assert_eq!(severed.len(), expected.len(), "{severed:#?}");
        for (reason, parts) in severed.iter().zip(expected) {
            for part in parts {
                assert!(reason.contains(part), "{part} in {reason}");
            }
        }
    }

    #[test]
    fn what_did_not_happen_is_not_named() {
        let calm = ModeCall {
            collapse: 0.0,
            reserve: Reserve::default(),
            retained: None,
            ..call(ModeRule::NoShare)
        };
        let text = reasons(&calm);
        assert_eq!(text.len(), 3);
        assert!(text[1].starts_with("no mode has 60 % of it"), "{}", text[1]);
        assert!(
            text[2].starts_with("no other mode would be called if 10 %"),
            "{}",
            text[2]
        );
        assert!(!text.concat().contains("collapse"));
    }
}
