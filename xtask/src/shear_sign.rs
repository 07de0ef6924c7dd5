//! `cargo xtask shear-sign`: which way friction points along a pin-loaded hole.
mod case; mod curve; mod depth; mod plan; mod plies;
use std::process::ExitCode;
use crate::publish::{self, Options, Publication, Trouble};
pub(crate) fn main(options: &Options) -> ExitCode { publish::main("shear-sign", options, compare) }
fn compare(quick: bool) -> Result<Publication, Trouble> {
    let plan = if quick { plan::Plan::quick() } else { plan::Plan::full() };
    let rows = publish::side_by_side(&plan.cases, |c| case::solve(c, plan.spacing))?;
    for r in &rows { for s in &r.steps { println!("{:?}|{}|{:?}|{:.0}|{:?}|{:?}|{:?}|{:.1}|{:?}", r.case.family, r.case.name, r.case.plate, s.load, s.phase, s.reading.pattern, s.reading.crossings, s.reading.end, s.reading.reversal); } }
    for f in [0.05,0.2] { for c in [0.0005,0.0015] { for a in depth::look(depth::Joint{friction:f,clearance:c}, plan.spacing)? { println!("D {f} {c} {} {} {:?}", a.load, a.depth, a.signs()); } } }
    for (n,l) in [("Coulomb",plan::coulomb(0.2)),("coverage",plan::usual_coverage())] { for cure in [0.0,-150.0] {
      for clearance in [0.0005, 0.001, 0.0015,0.002] {
      for c in plies::ask(&plies::Question{name:n,law:l.clone(),cure,clearance}, plan.spacing)? { println!("P {n} {cure} {clearance} {} {} peak {:?} at20 {:.2} at30 {:.2} at150 {:.2} {:?} {}", c.load,c.ply,c.peak(),c.at(20.0),c.at(30.0),c.at(150.0),c.cracked(),c.residual); } } } }
    Ok(Publication{tables:vec![],pictures:vec![],page:String::new(),findings:String::new()})
}
