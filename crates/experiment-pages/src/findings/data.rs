//! Sentences for findings of measured data.

use stickslip_experiment::Experiment;
use stickslip_measure::finding::{
    BackFinding, FieldFinding, FileFinding, LineFinding, PictureFinding, TableFinding,
};
use stickslip_text::{short, significant};

use super::shown;

pub(super) fn of_file(finding: &FileFinding) -> String {
    let FileFinding::IgnoredKey {
        file,
        line,
        key,
        why,
    } = finding;
    let line = line.map_or_else(String::new, |line| format!(":{line}"));
    format!(
        "{file}{line}: '{key}' has no effect: {why}; remove it, unless it waits for another method or other data."
    )
}

pub(super) fn of_table(experiment: &Experiment, finding: &TableFinding) -> String {
    let length = experiment.display.length;
    match finding {
        TableFinding::UnitNotCompared {
            file,
            line,
            column,
            unit,
            key,
        } => format!(
            "line {line} of '{file}' is a row of units and passed over; '{unit}' of column '{column}' is not compared with {key}."
        ),
        TableFinding::InsideHole {
            file,
            count,
            places,
            deepest: [x, y],
            depth,
        } => format!(
            "{count} of {places} valid places of '{file}' lie inside of the hole, the deepest at ({}, {}), {} from its edge, and are left out: \
             check origin, scale and y_axis, unless these are places on a pin.",
            length.show(*x),
            length.show(*y),
            length.show(*depth)
        ),
        TableFinding::Outliers {
            file,
            count,
            places,
            worst,
        } => format!(
            "{count} of {places} places of '{file}' disagree with their neighbours and are masked as outliers; the worst is in line {}, with \
             {} = {} where its neighbours give {}. [reduce] outliers = false keeps them.",
            worst.line,
            worst.field,
            shown(length, worst.value),
            shown(length, worst.expected)
        ),
    }
}

pub(super) fn of_field(experiment: &Experiment, finding: &FieldFinding) -> String {
    let length = experiment.display.length;
    match finding {
        FieldFinding::AsCalculated {
            field,
            deviation,
            of_range,
        } => format!(
            "{field} scatters by {} only, {} of its range, as calculated data do: bands hold this, not the error of a measurement or of a \
             mesh. State the standard deviation that a measurement has.",
            shown(length, *deviation),
            short(*of_range)
        ),
        FieldFinding::Deviation {
            field,
            deviation,
            by_digits: true,
        } => format!(
            "deviation of {field}: {}, by which its digits are rounded; its neighbours scatter by less.",
            shown(length, *deviation)
        ),
        FieldFinding::Deviation {
            field, deviation, ..
        } => format!(
            "deviation of {field} estimated from the scatter of neighbours: {}.",
            shown(length, *deviation)
        ),
        FieldFinding::RotationTakenOff {
            degrees,
            deviation_degrees,
            masked,
        } => rotation(*degrees, *deviation_degrees, *masked),
        FieldFinding::LargeDisplacements { of_extent } => format!(
            "Displacements differ by {:.0} % of the extent of their places, far beyond small strains: check scale and displacement_scale \
             (which is scale unless it is stated).",
            100.0 * of_extent
        ),
        FieldFinding::SameData { states } => format!(
            "States {} have the same data, number by number: name the file of each, or remove all but one; as data of friction and of its \
             laws they count {} times.",
            (states.iter().map(|name| format!("'{name}'")))
                .collect::<Vec<_>>()
                .join(", "),
            states.len()
        ),
    }
}

fn rotation(degrees: f64, deviation_degrees: f64, masked: usize) -> String {
    let masked = match masked {
        0 => String::new(),
        count => format!(
            "; {count} displacements are masked, because the other component of their place is not known"
        ),
    };
    format!(
        "the specimen turned by {}° ± {}° (by independent errors) against its reference picture: taken off as a finite rotation about the \
         middle of the hole{masked}.",
        short(degrees),
        significant(deviation_degrees, 2)
    )
}

pub(super) fn of_pictures(finding: &PictureFinding) -> String {
    match finding {
        PictureFinding::CarrierFound {
            field,
            carrier_per_mm: [x, y],
        } => format!(
            "The carrier of the {field} field was not stated: that which was found, ({x:.4}, {y:.4}) fringes/mm, was taken off, and with it \
             the mean strain of the plate."
        ),
        PictureFinding::PixelsApart { field, pixels } => format!(
            "{pixels} pixels of the {field} field are not connected to the largest region; their whole orders are not known, and \
             they are masked."
        ),
        PictureFinding::Unwrapping { fields } => {
            let each = fields
                .iter()
                .map(|own| format!("{} and {} in the {} field", own.loops, own.jumps, own.field));
            format!(
                "Unwrapping is inconsistent: loops of pixels that do not close, and neighbours half a fringe or more apart, are {}. They are \
                 marked on the map of the phase; pixels at the jumps are masked.",
                each.collect::<Vec<_>>().join(", ")
            )
        }
        PictureFinding::MapsBeforeNullField => {
            "the maps of phase and orders show the state before its null field, a table, is taken off."
                .to_owned()
        }
        PictureFinding::Stride { pixels } => format!(
            "one displacement per {pixels} × {pixels} pixels; [reduce] stride says otherwise."
        ),
        PictureFinding::FineFringes { field, part } => format!(
            "fringes of the {field} field are finer than two pixels at {} % of them and show false patterns there; take smaller pixels.",
            short(100.0 * part)
        ),
    }
}

pub(super) fn of_lines(experiment: &Experiment, finding: &LineFinding) -> String {
    let length = experiment.display.length;
    match finding {
        LineFinding::OffTrack {
            file,
            line,
            centre: [x, y],
            distance,
            fringe_line,
            count,
            centres,
            spacing,
        } => format!(
            "'{file}', line {line}: the fringe centre ({x}, {y}) lies {} off the track of fringe line '{fringe_line}', and {count} of its \
             {centres} centres lie farther off than half of {}, their median spacing along it. Between centres orders are taken along the \
             track: state another one (track, or tracks for single lines), or a tolerance if they belong there.",
            shown(length, *distance),
            shown(length, *spacing)
        ),
        LineFinding::BeyondNullField {
            count,
            fringe_line,
            place: [x, y],
        } => format!(
            "{count} fringe centres lie beyond the null field's lines and are left out, the first of line '{fringe_line}' at ({x}, {y}) mm."
        ),
        LineFinding::RotationKept { degrees, strain } => format!(
            "The specimen turned by {}° between the fringe lines of this state and those of no load, which strains them by {} in both \
             directions and is not taken off: turn the reference grating back, or give the displacements as a table.",
            short(*degrees),
            short(*strain)
        ),
    }
}

pub(super) fn of_back(finding: &BackFinding) -> String {
    match finding {
        BackFinding::FrontLacks { field } => format!(
            "the front has no {field} that the {field} of the back could be compared with."
        ),
        BackFinding::LinesOfFrontAlone { field, lines } => format!(
            "lines {} of the {field} field are not on the back and were not compared.",
            lines.join(", ")
        ),
        BackFinding::MeanStrainsNotSeen => {
            "Front and back are compared before the null field is taken off, the front less the carrier that was found in its own picture: a \
             difference of their mean strains is not seen."
                .to_owned()
        }
    }
}
