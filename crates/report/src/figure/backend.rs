//! A plotters backend that writes CSS classes where others write colours.
//!
//! plotters places points on a grid of whole pixels: it is given ten per user unit, so that lines keep a decimal. The
//! "colour" of an element is an index into the list of classes.

use std::convert::Infallible;

use plotters::style::RGBColor;
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
};

use super::svg::{Anchor, Svg};

/// plotters' pixels per user unit.
pub const GRID: f64 = 10.0;

/// Result of a drawing step; drawing into memory cannot fail.
type Drawn = Result<(), DrawingErrorKind<Infallible>>;

/// The backend.
pub struct ClassBackend<'a> {
    svg: &'a mut Svg,
    size: (u32, u32),
    classes: &'a [String],
}

impl<'a> ClassBackend<'a> {
    /// Draws into `svg`, whose size is given in user units.
    pub fn new(svg: &'a mut Svg, width: f64, height: f64, classes: &'a [String]) -> ClassBackend<'a> {
        ClassBackend { svg, size: ((width * GRID) as u32, (height * GRID) as u32), classes }
    }

    fn class(&self, color: BackendColor) -> &'a str {
        self.classes.get(color.rgb.0 as usize).map_or("", String::as_str)
    }
}

/// The colour that stands for the class with this index.
pub fn ink(index: usize) -> RGBColor {
    RGBColor(index.min(255) as u8, 0, 0)
}

fn user((x, y): BackendCoord) -> (f64, f64) {
    (f64::from(x) / GRID, f64::from(y) / GRID)
}

impl DrawingBackend for ClassBackend<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        let (x, y) = user(point);
        let class = self.class(color);
        self.svg.rect((x, y), (0.1, 0.1), class);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        let class = self.class(style.color());
        self.svg.line(user(from), user(to), class);
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        _fill: bool,
    ) -> Drawn {
        let ((x, y), (right, bottom)) = (user(upper_left), user(bottom_right));
        let class = self.class(style.color());
        self.svg.rect((x, y), (right - x, bottom - y), class);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn {
        let points: Vec<(f64, f64)> = path.into_iter().map(user).collect();
        let class = self.class(style.color());
        self.svg.path(&points, false, class);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, center: BackendCoord, radius: u32, style: &S, _fill: bool) -> Drawn {
        let class = self.class(style.color());
        self.svg.circle(user(center), f64::from(radius) / GRID, class);
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, vert: I, style: &S) -> Drawn {
        let points: Vec<(f64, f64)> = vert.into_iter().map(user).collect();
        let class = self.class(style.color());
        self.svg.path(&points, true, class);
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, pos: BackendCoord) -> Drawn {
        let (x, y) = user(pos);
        let size = style.size() / GRID;
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        let baseline = match style.anchor().v_pos {
            VPos::Top => y + 0.76 * size,
            VPos::Center => y + 0.34 * size,
            VPos::Bottom => y - 0.2 * size,
        };
        let degrees = match style.transform() {
            FontTransform::None => 0.0,
            FontTransform::Rotate90 => 90.0,
            FontTransform::Rotate180 => 180.0,
            FontTransform::Rotate270 => 270.0,
        };
        let class = self.class(style.color());
        self.svg.rotated_text((x, baseline), degrees, anchor, class, text);
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let size = style.size();
        Ok(((super::width::text_width(text) * size) as u32, size as u32))
    }
}
