//! What bodies by series cost: a pin of 14 load steps with friction without its files, in parts and as a ladder, and one more load step on
//! a ready operator.

use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use stickslip_contact::history::{LoadHistory, Ramp};

use stickslip_contact::solver::Step;
use stickslip_contact::{Chain, ContactState, Interface, InterfaceSolver};
use stickslip_engine::model::Model;
use stickslip_engine::run::{Operator, condense, follow, results, run_with, solve, solver};
use stickslip_ladder::run;
use stickslip_scene::schema::SolverChoice;
use stickslip_scene::{Format, Scene};

const NODES: [usize; 3] = [61, 121, 241];

/// scenes/pin-benchmark.toml without its mesh.
fn scene(changes: &[&str]) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
    let text = std::fs::read_to_string(path).expect("the scene is part of the repository");
    let (head, rest) = text.split_once("[mesh]").expect("it has a mesh");
    let (_, tail) = rest.split_once("\n\n").expect("something follows its mesh");
    let text = format!("{head}{tail}");
    let changes: Vec<String> = ["output.fields=none", "analysis.kinematics=small"]
        .iter()
        .chain(changes)
        .map(|change| (*change).to_owned())
        .collect();
    Scene::from_text(&text, Format::Toml, "pin", Path::new(""), &changes).expect("the scene reads")
}

fn with_nodes(count: usize) -> Scene {
    scene(&[&format!("analysis.contact_nodes={count}")])
}

fn runs(criterion: &mut Criterion) {
    let newton = solver(SolverChoice::default());
    for count in NODES {
        let scene = with_nodes(count);
        let mut measure = |name: &str, work: &dyn Fn()| {
            let name = format!("{name}, {count} nodes");
            criterion.bench_function(&name, |bencher| bencher.iter(work));
        };
        let model = || Model::build(&scene).expect("a model");
        let solved = |model: &Model| solve(model, newton.as_ref(), &mut |_| {}).expect("solved");
        measure("ladder", &|| drop(black_box(run(&scene, &mut |_| {}))));
        measure("one run", &|| {
            drop(black_box(run_with(&scene, newton.as_ref(), &mut |_| {})));
        });
        measure("model", &|| drop(black_box(model())));
        let ready = model();
        let interface = || {
            let operators = condense(&ready).expect("operators");
            let faces: Vec<_> = operators.iter().map(Operator::interface).collect();
            let interface = Interface::new(&faces, ready.pairs.clone()).expect("an interface");
            drop(faces);
            (operators, interface)
        };
        measure("interface", &|| drop(black_box(interface())));
        criterion.bench_function(&format!("history, {count} nodes"), |bencher| {
            let follow = |(operators, interface)| {
                follow(&ready, operators, interface, newton.as_ref(), &mut |_| {})
            };
            bencher.iter_with_setup(interface, follow);
        });
        criterion.bench_function(&format!("results, {count} nodes"), |bencher| {
            let of = |solved| results(&ready, newton.as_ref(), solved);
            bencher.iter_with_setup(|| solved(&ready), of);
        });
    }
}

/// One more load step: a little more of the load, by which no status changes, and the next of the history.
fn steps(criterion: &mut Criterion) {
    let chain = Chain::default();
    for count in NODES {
        let model = Model::build(&with_nodes(count)).expect("a model");
        let operators = condense(&model).expect("operators");
        let faces: Vec<_> = operators.iter().map(Operator::interface).collect();
        let interface = Interface::new(&faces, model.pairs.clone()).expect("an interface");
        let problem = interface.parts()[0].problem();
        let records = (model.history)
            .follow(problem, &chain, |_| {})
            .expect("every step is solved");
        let last = &records[6].state;
        let before = &records[5].state;
        let touching = |state: &ContactState| {
            let status = state.status.iter();
            status.filter(|status| status.touches()).count()
        };
        let mut measure = |name: &str, from: &ContactState, multipliers: &[f64]| {
            let name = format!("{name}, {count} nodes, {} touch", touching(from));
            criterion.bench_function(&name, |bencher| {
                bencher.iter(|| {
                    let step = Step::new(problem, black_box(from), multipliers);
                    chain.solve(&step).expect("solved")
                });
            });
        };
        let little: Vec<f64> = (last.multipliers.iter().zip(&before.multipliers))
            .map(|(last, before)| last + 1e-6 * (last - before))
            .collect();
        measure("step without a change", last, &little);
        measure("step with changes", before, &last.multipliers);
        measure("step of unloading", last, &records[7].state.multipliers);
        let history = LoadHistory::new(vec![last.multipliers.clone()], 1, Ramp::Linear);
        let history = history.expect("a history");
        criterion.bench_function(&format!("first step, {count} nodes"), |bencher| {
            bencher.iter(|| history.follow(problem, &chain, |_| {}));
        });
    }
}

criterion_group!(benches, runs, steps);
criterion_main!(benches);
