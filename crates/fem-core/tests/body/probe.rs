use std::sync::Arc;
use stickslip_fem_core::mesh::*;
use stickslip_fem_core::*;
use crate::fields::{THICKNESS, ply};
use crate::meshes::*;

fn sup(nodes: Vec<usize>, direction: HeldDirection) -> Support { Support { nodes, direction, displacement: 0.0 } }
fn body(mesh: Mesh) -> ElasticBody { let n = mesh.blocks().len(); ElasticBody::new(Arc::new(mesh), (0..n).map(|_| ply(0.5)).collect(), THICKNESS).unwrap() }

#[test]
fn all_interface() {
    let m = rectangle(ElementKind::Q4, [0.0,1.0],[0.0,1.0],[2,2]);
    let all: Vec<usize> = (0..9).collect();
    println!("all interface floating: {:?}", Arc::new(body(m.clone())).condense(&all).map(|c| c.compliance().unwrap().amax()));
    let most: Vec<usize> = (0..8).collect();
    println!("all but one interface floating: {:?}", Arc::new(body(m.clone())).condense(&most).map(|c| c.compliance().unwrap().amax()));
    println!("all interface held: {:?}", Arc::new(body(m.clone()).with_supports([sup(vec![0,3],HeldDirection::X),sup(vec![0],HeldDirection::Y)])).condense(&all).map(|c| c.compliance().unwrap().amax()));
}
#[test]
fn no_unknowns() {
    let m = rectangle(ElementKind::Q4, [0.0,1.0],[0.0,1.0],[1,1]);
    let b = Arc::new(body(m.clone()).with_supports([sup(vec![0,1,2,3],HeldDirection::X),sup(vec![0,1,2,3],HeldDirection::Y)]));
    println!("no unknowns {:?}", b.condense(&[0]).map(|c| c.displacements(&[1.0,0.0],&[],&[])));
    let b = Arc::new(body(m.clone()).with_supports([sup(vec![0,1,2,3],HeldDirection::X),sup(vec![0,1,2],HeldDirection::Y)]));
    println!("one unknown {:?}", b.condense(&[3]).map(|c| (c.compliance().cloned(), c.displacements(&[0.0,1.0],&[],&[]))));
    println!("one unknown, no interface {:?}", b.condense(&[]).map(|c| (c.compliance().cloned(), c.displacements(&[],&[],&[]))));
    let b = Arc::new(body(m.clone()).with_supports([sup(vec![0,1,2,3],HeldDirection::X),sup(vec![0,1],HeldDirection::Y)]));
    println!("two unknown {:?}", b.condense(&[3]).map(|c| (c.compliance().cloned(), c.displacements(&[0.0,1.0],&[],&[]))));
}
fn two(gap: f64, kind: ElementKind, cells: [usize;2]) -> Mesh {
    let a = rectangle(kind, [0.0,1.0],[0.0,1.0],cells).into_parts();
    let b = rectangle(kind, [1.0+gap,2.0+gap],[0.0,1.0],cells).into_parts();
    let mut p = MeshParts { nodes: a.nodes.clone(), blocks: a.blocks.clone(), ..MeshParts::default() };
    let n = p.nodes.len();
    p.nodes.extend(b.nodes.iter());
    let mut bl = b.blocks[0].clone();
    bl.connectivity.iter_mut().for_each(|k| *k += n);
    p.blocks.push(bl);
    Mesh::new(p).unwrap()
}
#[test]
fn disconnected() {
    for kind in ElementKind::ALL { for c in [[1,1],[2,2],[3,3],[5,4],[10,10],[20,20]] {
        let m = two(0.1, kind, c);
        println!("disconnected {kind:?} {c:?} {:?} {:?}", Arc::new(body(m.clone()).with_supports([sup(vec![0,1,2],HeldDirection::X),sup(vec![0,1,2],HeldDirection::Y)])).condense(&[3]).map(|c| (c.compliance().unwrap().amax())),
          Arc::new(body(m.clone())).condense(&[3]).map(|c| (c.compliance().unwrap().amax())));
    } }
}
#[test]
fn nan() {
    let m = rectangle(ElementKind::Q4, [0.0,1.0],[0.0,1.0],[1,1]);
    let mut s = sup(vec![0,1], HeldDirection::X); s.displacement = f64::NAN;
    println!("nan displacement {:?}", Arc::new(body(m.clone()).with_supports([s])).condense(&[3]).map(|c| c.compliance().unwrap().amax()));
    let (tx, rx) = std::sync::mpsc::channel();
    std::thread::spawn(move || { let r = Arc::new(body(m.clone()).with_supports([sup(vec![0,1], HeldDirection::Angle(f64::NAN))])).condense(&[3]).map(|c| c.compliance().unwrap().amax()); tx.send(r).unwrap(); });
    println!("nan angle {:?}", rx.recv_timeout(std::time::Duration::from_secs(3)));
}
#[test]
fn other_mesh() {
    let m = rectangle(ElementKind::Q4, [0.0,1.0],[0.0,1.0],[2,3]);
    let o = rectangle(ElementKind::Q4, [0.0,1.0],[0.0,1.0],[3,2]);
    let a = body(m); let st = a.analyse(&[0]).unwrap();
    println!("other mesh {:?}", CondensedBody::new(Arc::new(body(o)), st.clone()).map(|c| c.compliance().unwrap().amax()));
    println!("other supports {:?}", CondensedBody::new(Arc::new(a.with_supports([sup(vec![3],HeldDirection::X)])), st).map(|c| c.modes().ncols()));
}
