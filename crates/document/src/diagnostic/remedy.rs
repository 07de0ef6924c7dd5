//! Words that remedies share.

use stickslip_fem_core::material::MaterialError;

pub(super) fn meant(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!("did you mean '{name}'? "))
}

/// Where the meaning of a key is given that stands in the wrong table.
pub(super) fn elsewhere(key: &str) -> &'static str {
    match key {
        "yield" => {
            "a yield stress belongs to isotropic materials (`[materials.NAME.isotropic]`); a laminate fails by ply, so give strengths in \
                    `[plies.NAME.strengths]` and ask for `[failure]`; "
        }
        _ => "",
    }
}

pub(super) fn on_lines(lines: Option<(usize, usize)>) -> String {
    match lines {
        Some((first, second)) if first == second => format!(", both on line {first}"),
        Some((first, second)) => format!(", on lines {first} and {second}"),
        None => String::new(),
    }
}

/// An example in backticks, unless it marks what of it is code.
pub(super) fn coded(example: &str) -> String {
    if example.contains('`') {
        example.to_owned()
    } else {
        format!("`{example}`")
    }
}

pub(super) fn counted(count: usize, one: &'static str, many: &'static str) -> &'static str {
    if count == 1 { one } else { many }
}

pub(super) fn listed(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

pub(super) fn material_remedy(cause: &MaterialError) -> String {
    match cause {
        MaterialError::Poisson { .. } => {
            "metals have 0.25 to 0.35; ν = 0.5 is incompressible and has no plane-strain stiffness"
                .to_owned()
        }
        MaterialError::OrthotropicPoisson { limit, .. } => {
            format!(
                "give a magnitude below {limit:.4} = sqrt(Ei/Ej), or check which of the two moduli is which"
            )
        }
        MaterialError::OrthotropicIndefinite { .. } => {
            "make at least one of nu12, nu13 and nu23 smaller".to_owned()
        }
        _ => "a modulus is positive, and every constant is finite".to_owned(),
    }
}

/// What was passed over in a file, after a list of what is in it.
pub(super) fn of_file(notes: &[String]) -> String {
    if notes.is_empty() {
        return String::new();
    }
    format!(". Of its file: {}", notes.join("; "))
}
