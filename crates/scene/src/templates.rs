//! Commented scenes to start from.

/// A commented document that comes with the program.
#[derive(Debug)]
pub struct Template {
    /// Its name.
    pub name: &'static str,
    /// What it shows, in one line.
    pub summary: &'static str,
    /// The text, TOML with comments.
    pub text: &'static str,
    /// Data files that it refers to, written beside it.
    pub data: &'static [(&'static str, &'static str)],
}

/// All templates of scenes.
pub const TEMPLATES: [Template; 5] = [
    Template {
        name: "pin-loaded-plate",
        summary: "elastic pin in a plate of finite width, loaded and unloaded, static and dynamic friction",
        text: include_str!("templates/pin-loaded-plate.toml"),
        data: &[],
    },
    Template {
        name: "pin-infinite-plate",
        summary: "frictionless pin in an infinite plate, with the closed form to compare with",
        text: include_str!("templates/pin-infinite-plate.toml"),
        data: &[(
            "persson-ring5R-65deg.csv",
            include_str!("templates/persson-ring5R-65deg.csv"),
        )],
    },
    Template {
        name: "laminate-joint",
        summary: "pinned joint of a laminate: first ply, characteristic curve and the mode that governs",
        text: include_str!("templates/laminate-joint.toml"),
        data: &[],
    },
    Template {
        name: "hertz",
        summary: "cylinder pressed on a block of the same material, plane strain",
        text: include_str!("templates/hertz.toml"),
        data: &[],
    },
    Template {
        name: "open-hole",
        summary: "strip with a hole under tension, no contact",
        text: include_str!("templates/open-hole.toml"),
        data: &[],
    },
];
