//! Colours that stay apart in print and for colour-blind readers.
//!
//! Categories: Okabe & Ito, Color Universal Design (2008), its yellow replaced by
//! grey for white paper. Viridis: Smith & van der Walt, matplotlib (2015).
//! Blue–white–red and the single hues: ColorBrewer, Brewer (2003). The maps are
//! evaluated by the `colorous` crate, as is the circle of colours (sinebow: Bumgardner, 2012).

use std::fmt;

/// An opaque sRGB colour; displays as `#rrggbb`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red, 0 to 255.
    pub red: u8,
    /// Green, 0 to 255.
    pub green: u8,
    /// Blue, 0 to 255.
    pub blue: u8,
}

const CATEGORIES: [Color; 8] = [
    Color::rgb(0x00, 0x72, 0xb2),
    Color::rgb(0xd5, 0x5e, 0x00),
    Color::rgb(0x00, 0x9e, 0x73),
    Color::rgb(0xb0, 0x5a, 0x8f),
    Color::rgb(0x56, 0xb4, 0xe9),
    Color::rgb(0xe6, 0x9f, 0x00),
    Color::rgb(0x22, 0x22, 0x22),
    Color::rgb(0x80, 0x80, 0x80),
];

impl Color {
    /// Makes a colour from its sRGB channels, each 0 to 255.
    #[must_use]
    pub const fn rgb(red: u8, green: u8, blue: u8) -> Self {
        Self { red, green, blue }
    }

    /// How light the colour is, 0 to 255: Y' of Rec. 601.
    pub(crate) fn luminance(self) -> f64 {
        let [red, green, blue] = [self.red, self.green, self.blue].map(f64::from);
        0.299 * red + 0.587 * green + 0.114 * blue
    }

    /// The colour of category `index`; repeats after eight.
    pub fn category(index: usize) -> Self {
        CATEGORIES[index % CATEGORIES.len()]
    }

    /// Mixes this colour with white: `strength` \[1\] of 1 leaves it, 0 gives white.
    #[must_use]
    pub fn tint(self, strength: f64) -> Self {
        let strength = strength.clamp(0.0, 1.0);
        let mix = |channel: u8| (255.0 - strength * (255.0 - f64::from(channel))).round() as u8;
        Self::rgb(mix(self.red), mix(self.green), mix(self.blue))
    }
}

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.red, self.green, self.blue)
    }
}

fn evaluated(gradient: colorous::Gradient, fraction: f64) -> Color {
    let color = gradient.eval_continuous(fraction);
    Color::rgb(color.r, color.g, color.b)
}

/// A continuous map from \[0, 1\] to colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colormap {
    /// Dark blue over green to yellow, perceptually uniform: magnitudes.
    Viridis,
    /// Blue over white to red: signed values, white at zero.
    BlueWhiteRed,
    /// Black over grey to white: photographs.
    Gray,
    /// Round the circle of colours, ends alike: phases.
    Cyclic,
}

impl Colormap {
    /// The colour at `fraction` \[1\], which is clamped to \[0, 1\]; NaN gives the colour at 0.
    pub fn at(self, fraction: f64) -> Color {
        let fraction = if fraction.is_nan() {
            0.0
        } else {
            fraction.clamp(0.0, 1.0)
        };
        match self {
            Self::Viridis => evaluated(colorous::VIRIDIS, fraction),
            Self::BlueWhiteRed => evaluated(colorous::RED_BLUE, 1.0 - fraction),
            Self::Gray => {
                let level = (255.0 * fraction).round() as u8;
                Color::rgb(level, level, level)
            }
            Self::Cyclic => evaluated(colorous::SINEBOW, fraction),
        }
    }

    /// Checks whether the map's middle stands for zero.
    pub fn is_diverging(self) -> bool {
        self == Self::BlueWhiteRed
    }
}

/// Picks `count` colours in order from dark blue to light green, for a family of curves
/// that has an order: load steps, mesh levels, coefficients of friction.
pub fn sequence(count: usize) -> Vec<Color> {
    spread(count, 0.0, 0.85, |t| Colormap::Viridis.at(t))
}

/// Picks `count` colours for the steps of increasing load, from light to dark blue.
pub fn loading_sequence(count: usize) -> Vec<Color> {
    spread(count, 0.4, 1.0, |t| evaluated(colorous::BLUES, t))
}

/// Picks `count` colours for the steps of decreasing load, from dark to light orange.
pub fn unloading_sequence(count: usize) -> Vec<Color> {
    spread(count, 1.0, 0.4, |t| evaluated(colorous::ORANGES, t))
}

fn spread(count: usize, from: f64, to: f64, map: impl Fn(f64) -> Color) -> Vec<Color> {
    let intervals = count.saturating_sub(1).max(1) as f64;
    (0..count)
        .map(|step| map(from + (to - from) * step as f64 / intervals))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn families_have_as_many_distinct_colours_as_asked() {
        for count in [0, 1, 7, 14] {
            for family in [
                sequence(count),
                loading_sequence(count),
                unloading_sequence(count),
            ] {
                let distinct: HashSet<_> = family.iter().collect();
                assert_eq!(distinct.len(), count);
            }
        }
    }

    #[test]
    fn diverging_map_is_blue_below_and_red_above_and_light_at_the_middle() {
        let (low, middle, high) = (
            Colormap::BlueWhiteRed.at(0.0),
            Colormap::BlueWhiteRed.at(0.5),
            Colormap::BlueWhiteRed.at(1.0),
        );
        assert!(low.blue > low.red && high.red > high.blue);
        assert!(middle.red.min(middle.green).min(middle.blue) > 230);
    }

    #[test]
    fn maps_take_any_number() {
        assert_eq!(Colormap::Viridis.at(f64::NAN), Colormap::Viridis.at(-1.0));
        assert_eq!(
            Colormap::Viridis.at(f64::INFINITY),
            Colormap::Viridis.at(1.0)
        );
    }

    #[test]
    fn colours_are_written_in_hex_and_tinted_towards_white() {
        assert_eq!(Color::rgb(0, 16, 255).to_string(), "#0010ff");
        assert_eq!(Color::rgb(0, 0, 0).tint(0.0), Color::rgb(255, 255, 255));
        assert_eq!(Color::category(3).tint(1.0), Color::category(11));
    }
}
