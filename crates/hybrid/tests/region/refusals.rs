use stickslip_fem_core::mesh::ElementKind;
use stickslip_hybrid::data::Measurement;
use stickslip_hybrid::region::fit::{Amount, Smoothing};
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::{Region, RegionError};

use super::support::{body, sampled, sector, uniform};

#[test]
fn what_is_missing_is_named() {
    let body = body(sector([6, 3], ElementKind::Q8).mesh().unwrap());
    let region = Region::new(&body, &[]).unwrap();
    let good = sampled(body.mesh(), &region.prescribed_nodes(), uniform);
    let text = |measured| region.solve(&measured).unwrap_err().to_string();

    let mut short = good.clone();
    short.values.pop();
    assert!(text(short).contains("expected"));
    let mut nan = good.clone();
    nan.values[4] = f64::NAN;
    assert_eq!(
        text(nan),
        format!("displacement of node {} is not finite", good.nodes[2])
    );
    let mut missing = good.clone();
    let node = missing.nodes.pop().unwrap();
    missing.values.truncate(2 * missing.nodes.len());
    assert!(text(missing).starts_with(&format!("no displacement is given for node {node} at (")));
    let mut twice = good.clone();
    twice.nodes[1] = twice.nodes[0];
    assert!(matches!(
        region.solve(&twice),
        Err(RegionError::RepeatedNode { .. })
    ));
    let mut unknown = good.clone();
    unknown.nodes[0] = 1_000_000;
    assert!(matches!(region.solve(&unknown), Err(RegionError::Body(_))));
    let rows = EdgeRows::new(&body, "inner").unwrap().rows;
    assert_eq!(
        region.propagate(&rows, &good),
        Err(RegionError::NoCovariance)
    );
    let mut indefinite = good.clone();
    indefinite.covariance = vec![1.0; good.values.len() * good.values.len()];
    assert!(matches!(
        region.simulate(&rows, &indefinite, 1, 0),
        Err(RegionError::NotCovariance { row: 1 })
    ));
    assert!(EdgeRows::new(&body, "hole").is_err());
    assert!(matches!(
        Region::with_dofs(&body, &[0, 1]),
        Err(RegionError::Body(_))
    ));
    assert!(matches!(
        Region::with_dofs(&body, &[0, 1, 0]),
        Err(RegionError::Body(_))
    ));
    let folded = stickslip_hybrid::region::sector::ArcSector {
        outer: 5.0,
        ..sector([6, 3], ElementKind::Q8)
    };
    assert!(matches!(folded.mesh(), Err(RegionError::Generate(_))));
}

#[test]
fn data_that_do_not_cover_the_boundary_say_where() {
    let body = body(sector([6, 3], ElementKind::Q8).mesh().unwrap());
    let region = Region::new(&body, &[]).unwrap();
    let smoothing = Smoothing {
        order: 2,
        amount: Amount::CrossValidated { share: 1.0 },
    };
    let mut data = Measurement::default();
    assert!(matches!(
        region.fit(&data, smoothing),
        Err(RegionError::Deviation(_))
    ));
    data.deviation = [1e-4; 2];
    assert_eq!(
        region.fit(&data, smoothing),
        Err(RegionError::NoData { places: 0 })
    );
    // All in one corner.
    for k in 0..400 {
        let (theta, r) = (
            -0.85 + 0.1 * f64::from(k % 20) / 20.0,
            10.2 + f64::from(k / 20) / 20.0,
        );
        data.places
            .push([3.0 + r * theta.cos(), -1.0 + r * theta.sin()]);
    }
    for axis in 0..2 {
        data.displacements[axis] = vec![0.0; 400];
        data.valid[axis] = vec![true; 400];
    }
    assert!(matches!(
        region.fit(&data, smoothing),
        Err(RegionError::NotDetermined { .. })
    ));
    // So few in the corner that the region holds less than one per several of its cells.
    let few = Measurement {
        places: data.places.iter().copied().step_by(20).collect(),
        displacements: [vec![0.0; 20], vec![0.0; 20]],
        valid: [vec![true; 20], vec![true; 20]],
        ..data.clone()
    };
    assert!(matches!(
        region.fit(&few, smoothing),
        Err(RegionError::NotDetermined { .. })
    ));
    let order = Smoothing {
        order: 4,
        ..smoothing
    };
    assert_eq!(
        region.fit(&data, order),
        Err(RegionError::SmoothingOrder(4))
    );
    let amount = Smoothing {
        amount: Amount::Given(-1.0),
        ..smoothing
    };
    assert_eq!(
        region.fit(&data, amount),
        Err(RegionError::SmoothingAmount(-1.0))
    );
    let share = Smoothing {
        amount: Amount::CrossValidated { share: 0.0 },
        ..smoothing
    };
    assert_eq!(
        region.fit(&data, share),
        Err(RegionError::SmoothingAmount(0.0))
    );
    data.displacements[1][7] = f64::NAN;
    assert!(matches!(
        region.fit(&data, smoothing),
        Err(RegionError::NotFinite { index: 7, .. })
    ));
}
