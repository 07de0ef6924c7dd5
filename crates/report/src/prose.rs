//! Texts of several sentences: they stand in templates beside the code, one paragraph a line.

pub use minijinja::Value;
use minijinja::{Environment, UndefinedBehavior};

use crate::error::PageError;

/// A template with its data.
#[derive(Debug, Clone, PartialEq)]
pub struct Prose {
    template: &'static str,
    data: Value,
}

impl Prose {
    /// Makes a text from a template in the language of minijinja and the `data` that it names, made by [`context`](crate::context).
    pub fn new(template: &'static str, data: Value) -> Self {
        Self { template, data }
    }

    /// Fills the template; each line that is not empty is a paragraph.
    ///
    /// # Errors
    /// [`PageError::Template`] for a template that cannot be read, or that names what the data do not have.
    pub fn paragraphs(&self) -> Result<Vec<String>, PageError> {
        let mut environment = Environment::new();
        environment.set_undefined_behavior(UndefinedBehavior::Strict);
        let text = environment.render_str(self.template, &self.data)?;
        let lines = text.lines().map(str::trim);
        Ok(lines
            .filter(|line| !line.is_empty())
            .map(str::to_owned)
            .collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context;

    #[test]
    fn lines_are_paragraphs_and_nothing_is_left_out_silently() {
        let template = "One of {{ count }}.\n{% if more %}\nMore.\n{% endif %}\nLast <b>.\n";
        let prose = |more: bool| Prose::new(template, context! { count => 3, more });
        assert_eq!(
            prose(true).paragraphs().unwrap(),
            ["One of 3.", "More.", "Last <b>."]
        );
        assert_eq!(prose(false).paragraphs().unwrap().len(), 2);
        let lacking = Prose::new(template, context! { more => true });
        assert!(matches!(
            lacking.paragraphs(),
            Err(PageError::Template { .. })
        ));
    }
}
