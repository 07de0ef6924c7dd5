use std::time::Instant;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_hybrid::region::direct::interpolate;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::{Region, independent_covariance};

use super::support::{body, sampled, sector, uniform};

#[test]
fn few_outputs_and_many_give_the_same_derivatives_by_the_fewer_solves() {
    let body = body(sector([10, 5], ElementKind::Q8).mesh().unwrap());
    let region = Region::new(&body, &[]).unwrap();
    let columns = region.prescribed().len();
    let few = EdgeRows::new(&body, "inner").unwrap().rows;
    assert!(few.len() < columns);
    let mut many = few.clone();
    while many.len() <= columns {
        many.extend(few.clone());
    }
    let adjoint = region.transfer(&few).unwrap();
    let direct = region.transfer(&many).unwrap();
    assert_eq!((adjoint.solves, direct.solves), (few.len(), columns));
    assert_eq!(direct.shape(), [many.len(), columns]);
    let mut largest = 0.0_f64;
    let mut worst = 0.0_f64;
    for i in 0..few.len() {
        for j in 0..columns {
            largest = largest.max(adjoint.derivative(i, j).abs());
            worst = worst.max((adjoint.derivative(i, j) - direct.derivative(i, j)).abs());
        }
    }
    assert!(worst < 1e-11 * largest, "{worst} of {largest}");
    let measured = sampled(body.mesh(), &region.prescribed_nodes(), uniform);
    let solved = region.solve(&measured).unwrap().outputs(&few);
    let applied = adjoint.apply(&region.values(&measured).unwrap()).unwrap();
    assert!(
        solved
            .iter()
            .zip(&applied)
            .all(|(a, b)| (a - b).abs() < 1e-8)
    );
}

#[test]
fn a_thousand_draws_confirm_the_covariance_in_the_time_of_few_solves() {
    let body = body(sector([84, 39], ElementKind::Q8).mesh().unwrap());
    let start = Instant::now();
    let region = Region::new(&body, &[]).unwrap();
    let factorised = start.elapsed().as_secs_f64();
    let dofs = 2 * body.mesh().nodes().len();
    assert!(dofs > 20_000, "{dofs}");
    let rows = EdgeRows::new(&body, "inner").unwrap().rows;
    let mut measured = sampled(body.mesh(), &region.prescribed_nodes(), uniform);
    measured.covariance = correlated(body.mesh().nodes(), &measured.nodes);

    let one = Instant::now();
    for _ in 0..20 {
        std::hint::black_box(region.solve(&measured).unwrap());
    }
    let one = one.elapsed().as_secs_f64() / 20.0;
    // The solve alone, without the checks of the input and the recovery of the reactions around it.
    let values = region.values(&measured).unwrap();
    let single = Instant::now();
    for _ in 0..50 {
        std::hint::black_box(region.outputs_of(&[], &values).unwrap());
    }
    let single = single.elapsed().as_secs_f64() / 50.0;
    let linear = Instant::now();
    let propagated = region.propagate(&rows, &measured).unwrap();
    let linear = linear.elapsed().as_secs_f64();
    let drawn = Instant::now();
    let count = 1000;
    let draws = region.simulate(&rows, &measured, count, 7).unwrap();
    let drawn = drawn.elapsed().as_secs_f64();
    println!(
        "{dofs} displacements, {} prescribed, {} outputs: one state {:.2} ms of which solve {:.2} ms; factorisation and structure {:.0}, \
         covariance by {} solves {:.0}, 1000 draws {:.0}, all together {:.0} (in single pairs of triangular solves)",
        region.prescribed().len(),
        rows.len(),
        1e3 * one,
        1e3 * single,
        factorised / single,
        propagated.solves,
        linear / single,
        drawn / single,
        (factorised + linear + drawn) / single
    );
    assert_eq!(propagated.solves, rows.len().min(region.prescribed().len()));

    // The sample variance of n normal numbers deviates by √(2/n); the outputs together by no more than that of a few of them.
    let deviations = propagated.deviations();
    let outputs = rows.len();
    let ratios: Vec<f64> = (0..outputs)
        .map(|k| {
            let squares = draws
                .chunks_exact(outputs)
                .map(|draw| (draw[k] - propagated.values[k]).powi(2));
            squares.sum::<f64>() / count as f64 / deviations[k].powi(2)
        })
        .collect();
    let mean = ratios.iter().sum::<f64>() / outputs as f64;
    let worst = ratios.iter().map(|r| (r - 1.0).abs()).fold(0.0, f64::max);
    println!("sample over propagated variance: mean {mean:.3}, worst off by {worst:.3}");
    let one_sigma = (2.0 / count as f64).sqrt();
    assert!(worst < 5.0 * one_sigma, "{worst}");
    assert!((mean - 1.0).abs() < one_sigma, "{mean}");
    let again = region.simulate(&rows[..3], &measured, 2, 7).unwrap();
    assert_eq!(again, region.simulate(&rows[..3], &measured, 2, 7).unwrap());
}

/// Errors of 1e-4 that are correlated over a distance of 1, independent along x and y.
fn correlated(places: &[[f64; 2]], nodes: &[usize]) -> Vec<f64> {
    let size = 2 * nodes.len();
    let mut covariance = vec![0.0; size * size];
    for (i, &a) in nodes.iter().enumerate() {
        for (j, &b) in nodes.iter().enumerate() {
            let distance = (places[a][0] - places[b][0]).hypot(places[a][1] - places[b][1]);
            for axis in 0..2 {
                covariance[(2 * i + axis) * size + 2 * j + axis] = 1e-8 * (-distance).exp();
            }
        }
    }
    covariance
}

#[test]
fn direct_interpolation_has_the_covariance_of_its_draws() {
    let body = body(sector([10, 5], ElementKind::Q8).mesh().unwrap());
    let rows = EdgeRows::new(&body, "inner").unwrap().rows;
    let every: Vec<usize> = (0..body.mesh().nodes().len()).collect();
    let mut measured = sampled(body.mesh(), &every, uniform);
    let half = 1e-4;
    measured.covariance = independent_covariance(every.len(), [half / 3.0_f64.sqrt(); 2]);
    let found = interpolate(&body, &rows, &measured).unwrap();
    let mut random = StdRng::seed_from_u64(3);
    let count = 2000;
    let mut squares = vec![0.0; rows.len()];
    for _ in 0..count {
        let noise: Vec<f64> = measured
            .values
            .iter()
            .map(|_| random.random_range(-half..=half))
            .collect();
        for (square, row) in squares.iter_mut().zip(&rows) {
            *square += row
                .iter()
                .map(|&(dof, w)| w * noise[dof])
                .sum::<f64>()
                .powi(2);
        }
    }
    for (square, deviation) in squares.iter().zip(found.deviations()) {
        let ratio = square / f64::from(count) / (deviation * deviation);
        assert!(
            (ratio - 1.0).abs() < 5.0 * (2.0 / f64::from(count)).sqrt(),
            "{ratio}"
        );
    }
}
