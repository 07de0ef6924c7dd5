//! Pages and tables: complete, escaped, self-contained.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Series};
use stickslip_report::page::{Block, Figure, Page, PageError, Section};
use stickslip_report::svg::Svg;
use stickslip_report::table::{Column, Table};

fn picture() -> Svg {
    LineChart::new("Chart", Axis::linear("x"), Axis::linear("y"))
        .with(Series::new("", vec![[0.0, 0.0], [1.0, 1.0]]))
        .render()
        .unwrap()
}

fn zones() -> Table {
    let columns = vec![
        Column::new("CSTATUS", ""),
        Column::new("CPRESS", "MPa"),
        Column::new("CSLIP1", "mm"),
    ];
    let mut table = Table::new("Zones", columns).note("seen from the pin");
    table.push(["stick", "385.0", "–"]);
    table.push(["slip", "−2.1", "3.1×10⁻³"]);
    table
}

fn page() -> Page {
    let mut page = Page::new("Pin & plate <1>", "sub");
    page.warnings = vec!["<b>not converged</b>".to_owned()];
    page.summary = vec![("Peak \"pressure\"".to_owned(), "385 MPa".to_owned())];
    page.notes = vec!["half model".to_owned()];
    page.sections = vec![
        Section::new("Zones").with(Block::Table(zones())),
        Section::new("Figures")
            .with(Block::Text("a < b".to_owned()))
            .with(Block::Figure(Figure::new(
                picture(),
                "<i>caption</i>",
                "hole edge",
            ))),
    ];
    page.footer = String::from("stickslip");
    page
}

#[test]
fn every_text_is_escaped_and_every_figure_is_inline() {
    let html = page().render().unwrap();
    for expected in [
        "Pin &amp; plate &lt;1&gt;",
        "&lt;b&gt;not converged&lt;&#x2f;b&gt;",
        "&lt;i&gt;caption&lt;&#x2f;i&gt;",
        "a &lt; b",
        "id=\"hole-edge\"",
        "id=\"section:2\"",
        "href=\"#section:2\"",
        picture().as_str(),
    ] {
        assert!(html.contains(expected), "{expected}");
    }
    assert!(!html.contains("<b>") && !html.contains("<i>"));
}

#[test]
fn a_page_loads_nothing_and_runs_nothing() {
    let html = page().render().unwrap();
    for foreign in ["<script", "<link", "@import", "url(", "src=", "javascript:"] {
        assert!(!html.contains(foreign), "{foreign}");
    }
    let outside = html.matches("http").count();
    assert_eq!(
        outside,
        html.matches("http://www.w3.org/").count(),
        "only XML names"
    );
}

#[test]
fn numbers_are_aligned_right_and_units_have_a_row() {
    let html = page().render().unwrap();
    assert!(html.contains("<tr class=\"units\">"));
    assert!(html.contains("<td class=\"number\">−2.1</td>"));
    assert!(html.contains("<td>slip</td>"));
}

#[test]
fn an_empty_page_has_no_empty_parts() {
    let html = Page::new("Only a title", "").render().unwrap();
    for part in [
        "<nav",
        "<dl",
        "<section",
        "<ul",
        "<footer",
        "class=\"subtitle\"",
    ] {
        assert!(!html.contains(part), "{part}");
    }
}

#[test]
fn two_figures_cannot_share_an_anchor() {
    let mut page = page();
    let twin = Figure::new(picture(), "", "hole-edge");
    page.sections[1].blocks.push(Block::Figure(twin));
    let error = page.render().unwrap_err();
    assert!(matches!(error, PageError::DuplicateAnchor { anchor } if anchor == "hole-edge"));
}

#[test]
fn terminal_tables_are_aligned() {
    let text = zones().to_text(None);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "Zones");
    assert!(lines[2].contains("MPa") && lines[3].starts_with('─'));
    let column = |line: &str, end: &str| {
        let byte = line.find(end).unwrap() + end.len();
        line[..byte].chars().count()
    };
    assert_eq!(column(lines[4], "385.0"), column(lines[5], "−2.1"));
    assert_eq!(lines[6].trim(), "seen from the pin");
}

#[test]
fn uneven_rows_and_narrow_terminals_are_shown_in_full() {
    let mut table = zones();
    table.push(["open"]);
    table.push(["long", "1", "2", "a cell without a heading"]);
    let text = table.to_text(Some(40));
    assert!(
        text.lines().all(|line| line.chars().count() <= 40),
        "{text}"
    );
    assert!(text.contains("heading"));
    assert_eq!(Table::default().to_text(None).trim(), "");
}
