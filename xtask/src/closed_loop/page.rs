//! The table, the findings in words, and the page.

use stickslip_hybrid::identify::{Bounds, SlipFit};

use super::Trouble;
use super::study::Series;

/// One row per seed and zone, and one for all zones together.
pub(super) fn csv(all: [&Series; 2]) -> Result<Vec<u8>, Trouble> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "experiment",
        "truth",
        "seed",
        "zone",
        "from_deg",
        "to_deg",
        "mu",
        "low",
        "high",
        "holds_truth",
        "chi_squared",
        "degrees_of_freedom",
    ])?;
    for series in all {
        for one in &series.outcomes {
            let own = |name: &str, ends: Option<[f64; 2]>, fit: &SlipFit| -> Vec<String> {
                let (low, high) = ends_of(fit.bounds);
                let angle =
                    |k: usize| ends.map_or_else(String::new, |ends| format!("{:.2}", ends[k]));
                let number =
                    |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:.5}"));
                vec![
                    series.known.file.to_owned(),
                    series.known.mu.to_string(),
                    one.seed.to_string(),
                    name.to_owned(),
                    angle(0),
                    angle(1),
                    format!("{:.5}", fit.mu),
                    number(low),
                    number(high),
                    fit.bounds.contain(series.known.mu).to_string(),
                    format!("{:.2}", fit.chi_squared),
                    fit.degrees.to_string(),
                ]
            };
            for (state, ends, fit) in &one.zones {
                writer.write_record(own(&series.states[*state], Some(*ends), fit))?;
            }
            if let Some(fit) = &one.together {
                writer.write_record(own("together", None, fit))?;
            }
        }
    }
    Ok(writer.into_inner()?)
}

fn ends_of(bounds: Bounds) -> (Option<f64>, Option<f64>) {
    match bounds {
        Bounds::Between(low, high) => (Some(low), Some(high)),
        Bounds::AtMost(high) => (None, Some(high)),
        Bounds::AtLeast(low) => (Some(low), None),
        Bounds::Nothing => (None, None),
    }
}

/// The findings, one sentence each.
pub(super) fn findings(rubbing: &Series, smooth: &Series) -> Vec<String> {
    let [mean, spread] = rubbing.mean_and_spread();
    let count = rubbing.outcomes.len();
    let mut found = vec![
        format!(
            "Truth μd = {}: over {count} seeds the mean is {mean:.4}, the standard deviation {spread:.4}, the bias {:+.4}; the farthest \
             seed is {:.4} away.",
            rubbing.known.mu,
            mean - rubbing.known.mu,
            rubbing.farthest()
        ),
        format!(
            "The interval of 95 % holds the truth for {} of {count} seeds ({:.1} %); its half width is {:.4} in the mean, {:.2} standard \
             deviations of the seeds.",
            rubbing.covered(),
            100.0 * rubbing.coverage(),
            rubbing.half_width(),
            rubbing.half_width() / spread
        ),
    ];
    for (index, name) in rubbing.states.iter().enumerate() {
        found.push(of_state(rubbing, index, name));
    }
    found.push(without(smooth));
    found
}

/// The zones of one state alone.
fn of_state(series: &Series, index: usize, name: &str) -> String {
    let zones: Vec<_> = (series.outcomes.iter())
        .flat_map(|one| one.zones.iter().filter(|zone| zone.0 == index))
        .collect();
    let count = zones.len() as f64;
    let mean = zones.iter().map(|zone| zone.2.mu).sum::<f64>() / count;
    let spread = zones
        .iter()
        .map(|zone| (zone.2.mu - mean).powi(2))
        .sum::<f64>()
        / (count - 1.0);
    let covered = zones
        .iter()
        .filter(|zone| zone.2.bounds.contain(series.known.mu))
        .count();
    let end = |k: usize| zones.iter().map(|zone| zone.1[k]).sum::<f64>() / count;
    format!(
        "State '{name}' alone: {} zones, from {:.1}° to {:.1}° in the mean; mean {mean:.4}, standard deviation {:.4}, {covered} hold the \
         truth.",
        zones.len(),
        end(0),
        end(1),
        spread.sqrt()
    )
}

fn without(smooth: &Series) -> String {
    let fits = || {
        smooth
            .outcomes
            .iter()
            .filter_map(|one| one.together.as_ref())
    };
    let at_most = fits()
        .filter(|fit| matches!(fit.bounds, Bounds::AtMost(_)))
        .count();
    let highest = fits()
        .filter_map(|fit| ends_of(fit.bounds).1)
        .fold(0.0, f64::max);
    format!(
        "Without friction {at_most} of {} seeds say that there is none or at most a little; no upper end is above {highest:.4}.",
        smooth.outcomes.len()
    )
}

/// The page.
pub(super) fn page(rubbing: &Series, smooth: &Series) -> String {
    let list: Vec<String> = findings(rubbing, smooth)
        .into_iter()
        .map(|finding| format!("- {finding}"))
        .collect();
    format!(
        "<!-- Generated by `cargo xtask closed-loop`; do not edit. -->\n\n# Friction from fringe pictures: the closed loop\n\n\
         The aluminium plate of [`scenes/hybrid-aluminium`](../../scenes/hybrid-aluminium/README.md) is solved with static friction 0.35 and \
         dynamic friction 0.25, photographed through a moiré interferometer with 2400 lines/mm while the load grows and while it falls, \
         and its friction is identified from the pictures by what `stickslip identify` does. Each seed has other noise: every pixel's \
         order is off by a number uniform in ±¼ fringe, independent of its neighbours', the camera adds 1 % of full scale and 8 bits. \
         The truth's mesh is three times finer than the region's. Cells, margin and smoothing amount of the experiment were chosen with \
         seeds 1 to 20, knowing the truth; none of these is among the seeds here.\n\n\
         {}\n\n\
         ![Intervals](closed-loop.png)\n\n\
         Every seed and zone: [closed-loop.csv](closed-loop.csv).\n\n\
         What limits it: the noise is that of a band of the spectrum, so that errors of neighbouring data go together; their variance is \
         taken from means of neighbouring residuals. Smoothing and cells leave a bias near the ends of contact and of slip, where \
         stresses are not smooth; twice the angle that the edge resolves is left out there, and the estimated bias is a declared part of \
         the deviation. The choice of the zone is in no interval.\n",
        list.join("\n")
    )
}
