//! The compliance of the contact points.
//!
//! Where a body has its compliance in [blocks](BlockCompliance), so has the problem: points whose motion depends on one block of a body, or
//! on a body with one matrix, form a block, and between blocks act the shapes of the bodies' own,
//!
//! ```text
//! A = diag(A_1, …) + V M Vᵀ,     V = B U
//! ```

use std::borrow::Cow;
use std::ops::Range;

use nalgebra::{DMatrix, DVector, Matrix2};
use stickslip_fem_core::{Block, BlockCompliance, InterfaceOperator};

use super::{BodyRows, Contacts};

/// Compliance A `[length/force]`, 2n × 2n, symmetric positive semidefinite.
#[derive(Clone, Debug, PartialEq)]
pub struct Compliance {
    /// Empty where it is held in blocks.
    matrix: DMatrix<f64>,
    blocks: Option<BlockCompliance>,
}

impl From<DMatrix<f64>> for Compliance {
    fn from(matrix: DMatrix<f64>) -> Self {
        Self {
            matrix,
            blocks: None,
        }
    }
}

/// Rows and columns of a compliance at hand: entry (i, c) is that of the chosen row i and of column c of the whole.
pub(crate) struct Chosen<'a> {
    matrix: Cow<'a, DMatrix<f64>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
}

impl Chosen<'_> {
    /// The entry of the chosen row `row`, counted among the chosen ones, and of the column `column` of the whole, a chosen one.
    pub(crate) fn at(&self, row: usize, column: usize) -> f64 {
        self.matrix[(self.rows[row], self.columns[column])]
    }
}

impl Compliance {
    /// The matrix `[length/force]`, 2n × 2n, if it is held as one.
    pub fn matrix(&self) -> Option<&DMatrix<f64>> {
        self.blocks.is_none().then_some(&self.matrix)
    }

    /// The blocks, if it is held in blocks.
    pub fn blocks(&self) -> Option<&BlockCompliance> {
        self.blocks.as_ref()
    }

    /// The matrix `[length/force]`, 2n × 2n, made of the blocks where it is held in blocks.
    pub fn to_matrix(&self) -> Cow<'_, DMatrix<f64>> {
        match &self.blocks {
            None => Cow::Borrowed(&self.matrix),
            Some(blocks) => Cow::Owned(blocks.matrix()),
        }
    }

    /// How many numbers are held `[1]`.
    pub fn entries(&self) -> usize {
        self.blocks
            .as_ref()
            .map_or(self.matrix.len(), BlockCompliance::entries)
    }

    /// The compliance of each component under its own force `[length/force]`, 2n.
    pub fn diagonal(&self) -> DVector<f64> {
        match &self.blocks {
            None => self.matrix.diagonal(),
            Some(blocks) => blocks.diagonal(),
        }
    }

    /// The entries in `rows` and `columns`.
    pub(crate) fn chosen(&self, rows: &[usize], columns: &[usize]) -> Chosen<'_> {
        let Some(blocks) = &self.blocks else {
            return Chosen {
                matrix: Cow::Borrowed(&self.matrix),
                rows: rows.to_vec(),
                columns: (0..self.matrix.ncols()).collect(),
            };
        };
        let mut place = vec![0; blocks.order()];
        for (own, &column) in columns.iter().enumerate() {
            place[column] = own;
        }
        Chosen {
            matrix: Cow::Owned(blocks.part(rows, columns)),
            rows: (0..rows.len()).collect(),
            columns: place,
        }
    }

    /// Adds the motion A λ by the contact forces `forces`.
    pub(crate) fn add_motion(&self, forces: &DVector<f64>, motion: &mut DVector<f64>) {
        if let Some(blocks) = &self.blocks {
            *motion += blocks.times(forces);
            return;
        }
        for (column, &force) in forces.iter().enumerate() {
            if force != 0.0 {
                motion.axpy(force, &self.matrix.column(column), 1.0);
            }
        }
    }

    /// The matrix, which takes the place of blocks.
    pub(super) fn make_matrix(&mut self) -> &mut DMatrix<f64> {
        if let Some(blocks) = self.blocks.take() {
            self.matrix = blocks.matrix();
        }
        &mut self.matrix
    }
}

/// Adds B C Bᵀ to `target`: for each point the body's motion C Bᵀ under unit contact forces there, seen from the points after it.
pub(super) fn add_compliance(
    target: &mut DMatrix<f64>,
    rows: &[BodyRows],
    compliance: &DMatrix<f64>,
) {
    let nodes = || {
        rows.iter()
            .flat_map(|row| &row.terms)
            .map(|(node, _)| *node)
    };
    let (Some(first), Some(last)) = (nodes().min(), nodes().max()) else {
        return;
    };
    let (start, length) = (2 * first, 2 * (last + 1 - first));
    let mut motion = DMatrix::zeros(compliance.nrows(), 2);
    for (j, pushed) in rows.iter().enumerate() {
        motion.fill(0.0);
        for (node, weight) in &pushed.terms {
            for component in 0..2 {
                let mut column = motion.column_mut(component);
                let mut column = column.rows_range_mut(start..start + length);
                for axis in 0..2 {
                    let factor = weight[(component, axis)];
                    let unit = compliance.column(2 * node + axis);
                    column.axpy(factor, &unit.rows(start, length), 1.0);
                }
            }
        }
        for seen in &rows[j..] {
            let mut block = Matrix2::zeros();
            for (node, weight) in &seen.terms {
                block += weight * motion.fixed_view::<2, 2>(2 * node, 0);
            }
            let [row, column] = [2 * seen.point, 2 * pushed.point];
            if row == column {
                block[(0, 1)] = block[(1, 0)];
            } else {
                let mut mirror = target.fixed_view_mut::<2, 2>(column, row);
                mirror += block.transpose();
            }
            let mut target = target.fixed_view_mut::<2, 2>(row, column);
            target += block;
        }
    }
}

/// The compliance of the points of `contacts` between `bodies`.
pub(super) fn assemble(contacts: &Contacts, bodies: &[&dyn InterfaceOperator]) -> Compliance {
    let rows: Vec<Vec<BodyRows>> = (0..bodies.len())
        .map(|body| contacts.body_rows(body))
        .collect();
    if bodies.iter().any(|body| body.blocks().is_some()) {
        let groups = Groups::new(contacts.points().len(), bodies, rows);
        return Compliance {
            matrix: DMatrix::zeros(0, 0),
            blocks: Some(groups.compliance()),
        };
    }
    let size = 2 * contacts.points().len();
    let mut matrix = DMatrix::zeros(size, size);
    for (body, rows) in bodies.iter().zip(&rows) {
        if let Some(compliance) = body.compliance() {
            add_compliance(&mut matrix, rows, compliance);
        }
    }
    matrix.into()
}

/// Points that share a block of a body, or a body with one matrix, group by group.
struct Groups<'a> {
    bodies: &'a [&'a dyn InterfaceOperator],
    rows: Vec<Vec<BodyRows>>,
    points: Vec<Vec<usize>>,
    /// Group of each point, and its number there.
    place: Vec<(usize, usize)>,
}

impl<'a> Groups<'a> {
    fn new(
        count: usize,
        bodies: &'a [&'a dyn InterfaceOperator],
        rows: Vec<Vec<BodyRows>>,
    ) -> Self {
        let mut parent: Vec<usize> = (0..count).collect();
        for (body, rows) in bodies.iter().zip(&rows) {
            let parts = body.blocks().map_or(1, |blocks| blocks.blocks().len());
            let mut one_of: Vec<Option<usize>> = vec![None; parts];
            for row in rows.iter().filter(|_| body.gives()) {
                for &(node, _) in &row.terms {
                    let part = body.blocks().map_or(0, |blocks| blocks.place(2 * node).0);
                    let other = *one_of[part].get_or_insert(row.point);
                    let [a, b] = [row.point, other].map(|point| root(&mut parent, point));
                    parent[a.max(b)] = a.min(b);
                }
            }
        }
        let mut points: Vec<Vec<usize>> = Vec::new();
        let mut group = vec![0; count];
        let mut place = Vec::with_capacity(count);
        for point in 0..count {
            // A root is the least of its points, so it comes first.
            let first = root(&mut parent, point);
            if first == point {
                group[point] = points.len();
                points.push(Vec::new());
            }
            let own = group[first];
            place.push((own, points[own].len()));
            points[own].push(point);
        }
        Self {
            bodies,
            rows,
            points,
            place,
        }
    }

    fn compliance(&self) -> BlockCompliance {
        let mut shapes = vec![Vec::new(); self.points.len()];
        let mut own: Vec<DMatrix<f64>> = (self.points.iter())
            .map(|points| DMatrix::zeros(2 * points.len(), 2 * points.len()))
            .collect();
        for body in 0..self.bodies.len() {
            for (group, rows) in self.rows_by_group(body).into_iter().enumerate() {
                if !rows.is_empty() {
                    shapes[group].extend(self.add_body(body, rows, &mut own[group]));
                }
            }
        }
        let core = self.core(&shapes);
        let blocks = (self.points.iter().zip(own)).zip(shapes);
        let blocks = blocks.map(|((points, own), shapes)| {
            let columns: usize = shapes.iter().map(|own: &Shapes| own.seen.ncols()).sum();
            let mut all = DMatrix::zeros(own.nrows(), columns);
            let mut first = 0;
            for own in &shapes {
                let mut target = all.columns_mut(first, own.seen.ncols());
                target.copy_from(&own.seen);
                first += own.seen.ncols();
            }
            Block {
                rows: points.iter().flat_map(|k| [2 * k, 2 * k + 1]).collect(),
                own,
                shapes: all,
            }
        });
        BlockCompliance::new(blocks.collect(), core)
    }

    /// The rows of `body` of the points of each group, which are counted in the group.
    fn rows_by_group(&self, body: usize) -> Vec<Vec<BodyRows>> {
        let mut all = vec![Vec::new(); self.points.len()];
        for row in self.rows[body].iter().filter(|_| self.bodies[body].gives()) {
            let (group, point) = self.place[row.point];
            all[group].push(BodyRows {
                point,
                terms: row.terms.clone(),
            });
        }
        all
    }

    /// Adds the compliance of `body` at the points of `rows`, those of one group, to `own`, and returns what reaches other groups.
    fn add_body(
        &self,
        body: usize,
        mut rows: Vec<BodyRows>,
        own: &mut DMatrix<f64>,
    ) -> Vec<Shapes> {
        let Some(blocks) = self.bodies[body].blocks() else {
            if let Some(compliance) = self.bodies[body].compliance() {
                add_compliance(own, &rows, compliance);
            }
            return Vec::new();
        };
        let terms = || rows.iter().flat_map(|row| &row.terms);
        let mut parts: Vec<usize> = terms().map(|(node, _)| blocks.place(2 * node).0).collect();
        parts.sort_unstable();
        parts.dedup();
        let shapes = (parts.iter())
            .map(|&part| Shapes::seen_from(&rows, own.nrows(), body, part, blocks))
            .collect();
        let at: Vec<usize> = (parts.iter())
            .flat_map(|&part| &blocks.blocks()[part].rows)
            .copied()
            .collect();
        let mut place = vec![0; blocks.order()];
        for (own, &row) in at.iter().enumerate() {
            place[row] = own;
        }
        for (node, _) in rows.iter_mut().flat_map(|row| &mut row.terms) {
            *node = place[2 * *node] / 2;
        }
        match parts[..] {
            [part] => add_compliance(own, &rows, &blocks.blocks()[part].own),
            _ => add_compliance(own, &rows, &blocks.part(&at, &at)),
        }
        shapes
    }

    /// M between the shapes of all groups, which are those of the bodies' blocks.
    fn core(&self, shapes: &[Vec<Shapes>]) -> DMatrix<f64> {
        let all = || {
            let of_group =
                |(group, own): (usize, &'_ Vec<Shapes>)| own.iter().map(move |_| group).collect();
            let groups: Vec<Vec<usize>> = shapes.iter().enumerate().map(of_group).collect();
            groups.into_iter().flatten().zip(shapes.iter().flatten())
        };
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for (_, own) in all() {
            let start = ranges.last().map_or(0, |last| last.end);
            ranges.push(start..start + own.seen.ncols());
        }
        let total = ranges.last().map_or(0, |last| last.end);
        let mut core = DMatrix::zeros(total, total);
        for ((group, own), rows) in all().zip(&ranges) {
            let Some(blocks) = self.bodies[own.body].blocks() else {
                continue;
            };
            for ((other_group, other), columns) in all().zip(&ranges) {
                if group != other_group && own.body == other.body {
                    let (from, to) = (blocks.shapes_of(own.part), blocks.shapes_of(other.part));
                    let between = blocks
                        .core()
                        .view((from.start, to.start), (from.len(), to.len()));
                    let place = (rows.start, columns.start);
                    core.view_mut(place, between.shape()).copy_from(&between);
                }
            }
        }
        core
    }
}

/// The shapes of a body's block, as they are seen at the points of a group.
#[derive(Clone)]
struct Shapes {
    body: usize,
    part: usize,
    seen: DMatrix<f64>,
}

impl Shapes {
    fn seen_from(
        rows: &[BodyRows],
        size: usize,
        body: usize,
        part: usize,
        blocks: &BlockCompliance,
    ) -> Self {
        let own = &blocks.blocks()[part].shapes;
        let mut seen = DMatrix::zeros(size, own.ncols());
        for row in rows {
            for (node, weight) in &row.terms {
                let (of, local) = blocks.place(2 * node);
                if of == part {
                    let mut target = seen.rows_mut(2 * row.point, 2);
                    target += weight * own.rows(local, 2);
                }
            }
        }
        Self { body, part, seen }
    }
}

fn root(parent: &mut [usize], mut point: usize) -> usize {
    while parent[point] != point {
        parent[point] = parent[parent[point]];
        point = parent[point];
    }
    point
}
