//! Plots of a study, as SVG or PNG.

use std::error::Error as StdError;
use std::ops::Range;
use std::sync::Once;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

use super::study::Study;
use crate::MethodSummary;
use crate::Swept;
use crate::statistics::quantile;

/// Width of every plot, pixels.
const WIDTH: u32 = 900;
/// Height of a plot of curves, pixels.
const HEIGHT: u32 = 420;
/// Height of a row of a box plot, pixels.
const ROW: u32 = 46;
/// Largest number on an axis, in its unit; beyond it ticks can no longer be distinguished.
const LARGEST_DRAWN: f64 = 1e12;
/// Smallest range of an axis relative to the numbers on it.
const NARROWEST_DRAWN: f64 = 1e-9;
/// Maximum number of boxes in one plot; for longer sweeps every k-th variant is shown.
const MOST_BOXES: usize = 12;
/// Colours that colour-blind readers can distinguish (Okabe and Ito, 2008).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// A plot that has not been drawn yet.
#[derive(Debug, Clone)]
pub struct Plot {
    /// Title; the file is named after it.
    pub title: String,
    axis: String,
    kind: Kind,
}

#[derive(Debug, Clone)]
enum Kind {
    Boxes(Vec<BoxOf>),
    Curves { x: String, series: Vec<(String, Vec<(f64, f64)>)> },
}

/// Whether a number can be shown on an axis; a file that was tampered with may contain anything.
fn drawable(number: &f64) -> bool {
    number.abs() <= LARGEST_DRAWN
}

/// Five quantiles and the outliers.
#[derive(Debug, Clone)]
struct BoxOf {
    name: String,
    quantiles: [f64; 5],
    outliers: Vec<f64>,
}

impl BoxOf {
    /// Whiskers reach to the last value within 1.5 box lengths of the box (Tukey).
    fn new(name: &str, mut values: Vec<f64>) -> Option<Self> {
        values.retain(drawable);
        values.sort_unstable_by(f64::total_cmp);
        let [q25, median, q75] = [0.25, 0.5, 0.75].map(|p| quantile(&values, p));
        let reach = 1.5 * (q75 - q25);
        let inside = |v: &&f64| (q25 - reach..=q75 + reach).contains(*v);
        let (low, high) = (*values.iter().find(inside)?, *values.iter().rev().find(inside)?);
        let outliers = values.iter().filter(|v| !inside(v)).copied().collect();
        Some(BoxOf { name: name.to_string(), quantiles: [low, q25, median, q75, high], outliers })
    }

    fn range(&self) -> Range<f64> {
        let all = || self.outliers.iter().chain(&self.quantiles).copied();
        all().fold(f64::INFINITY, f64::min)..all().fold(f64::NEG_INFINITY, f64::max)
    }
}

/// All plots of a study: costs of each scenario as boxes, and for sweeps the reduction of the first repeat as boxes and
/// reduction and time as curves.
pub(super) fn plots(study: &Study) -> Vec<Plot> {
    let mut plots = Vec::new();
    let mut scenarios: Vec<&str> = study.summary.methods.iter().map(|m| m.scenario.as_str()).collect();
    scenarios.dedup();
    for scenario in scenarios {
        let plain = study.summary.methods.iter().filter(|m| m.scenario == scenario && m.sweep.is_none());
        let costs = |m: &&MethodSummary| study.costs_of(m).iter().map(|c| c.cost).collect();
        plots.extend(boxes(format!("{scenario}: path cost"), "m", plain.map(|m| (m.method.as_str(), costs(&m)))));
    }
    for ((scenario, of), variants) in study.families() {
        let first = variants.iter().filter_map(|(_, s)| s.repeats).min();
        let shown = variants.iter().filter(|(_, s)| s.repeats == first);
        let reductions = |m: &MethodSummary| study.costs_of(m).iter().map(|c| c.reduction()).collect();
        let title = format!("{scenario}, {of}: reduction of path cost, single trials");
        plots.extend(boxes(title, "%", shown.map(|(m, _)| (m.method.as_str(), reductions(m)))));
        plots.extend(curves(&format!("{scenario}, {of}"), &variants));
    }
    plots
}

fn boxes<'a>(title: String, axis: &str, values: impl Iterator<Item = (&'a str, Vec<f64>)>) -> Option<Plot> {
    let all: Vec<BoxOf> = values.filter_map(|(name, values)| BoxOf::new(name, values)).collect();
    let every = all.len().div_ceil(MOST_BOXES).max(1);
    let shown: Vec<BoxOf> = all.into_iter().step_by(every).collect();
    (!shown.is_empty()).then(|| Plot { title, axis: axis.to_string(), kind: Kind::Boxes(shown) })
}

/// Reduction and time of a sweep over its steps or its repeats.
fn curves(title: &str, variants: &[(&MethodSummary, &Swept)]) -> Vec<Plot> {
    let over_step = variants.iter().any(|(_, s)| s.step.is_some());
    let x = |s: &Swept| if over_step { s.step } else { s.repeats.map(|r| r as f64) };
    let label = |s: &Swept| {
        let repeats = s.repeats.filter(|_| over_step).map(|r| format!("repeats {r}"));
        let post = s.post.as_deref().map(|post| match post {
            "backward" | "forward" => format!("{post} first"),
            other => other.to_string(),
        });
        post.into_iter().chain(repeats).collect::<Vec<_>>().join(", ")
    };
    type Measured = (&'static str, &'static str, fn(&MethodSummary) -> Option<f64>);
    let measures: [Measured; 3] = [
        ("mean reduction of path cost", "%", |m| m.reduction.mean.map(|r| 100.0 * r)),
        ("mean time of rewinding", "µs", |m| m.post_seconds.mean.map(|s| 1e6 * s)),
        ("median time of rewinding", "µs", |m| m.post_seconds.median.map(|s| 1e6 * s)),
    ];
    let plot = |(name, axis, of): Measured| {
        let mut series: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
        for (method, sweep) in variants {
            let (Some(x), Some(y)) = (x(sweep).filter(drawable), of(method).filter(drawable)) else { continue };
            let label = label(sweep);
            match series.iter_mut().find(|(known, _)| *known == label) {
                Some((_, points)) => points.push((x, y)),
                None => series.push((label, vec![(x, y)])),
            }
        }
        series.iter_mut().for_each(|(_, points)| points.sort_unstable_by(|a, b| a.0.total_cmp(&b.0)));
        series.retain(|(_, points)| points.len() > 1);
        let x = if over_step { "step, m" } else { "repeats" }.to_string();
        let kind = Kind::Curves { x, series };
        Plot { title: format!("{title}: {name}"), axis: axis.to_string(), kind }
    };
    let has_curves = |plot: &Plot| matches!(&plot.kind, Kind::Curves { series, .. } if !series.is_empty());
    measures.map(plot).into_iter().filter(has_curves).collect()
}

impl Plot {
    /// The plot as an SVG element.
    pub fn svg(&self) -> String {
        let mut svg = String::new();
        self.draw(&SVGBackend::with_string(&mut svg, self.size()).into_drawing_area()).expect("writing to memory");
        svg
    }

    /// The plot as rows of red, green and blue bytes, and its width and height in pixels.
    pub fn pixels(&self) -> (Vec<u8>, (u32, u32)) {
        let (width, height) = self.size();
        let mut pixels = vec![0; 3 * (width * height) as usize];
        let area = BitMapBackend::with_buffer(&mut pixels, (width, height)).into_drawing_area();
        self.draw(&area).expect("drawing to memory");
        drop(area);
        (pixels, (width, height))
    }

    fn size(&self) -> (u32, u32) {
        match &self.kind {
            Kind::Boxes(boxes) => (WIDTH, 90 + ROW * boxes.len() as u32),
            Kind::Curves { .. } => (WIDTH, HEIGHT),
        }
    }

    fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> Result<(), Box<dyn StdError>>
    where
        DB::ErrorType: 'static,
    {
        static FONT: Once = Once::new();
        FONT.call_once(|| {
            let registered = register_font("sans-serif", FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT);
            assert!(registered.is_ok(), "a sound font");
        });
        area.fill(&WHITE)?;
        match &self.kind {
            Kind::Boxes(boxes) => self.draw_boxes(area, boxes)?,
            Kind::Curves { x, series } => self.draw_curves(area, x, series)?,
        }
        area.present()?;
        Ok(())
    }

    fn draw_boxes<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        boxes: &[BoxOf],
    ) -> Result<(), Box<dyn StdError>>
    where
        DB::ErrorType: 'static,
    {
        let names = 7 * boxes.iter().map(|b| b.name.chars().count()).max().unwrap_or(0).min(50) as u32;
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, ("sans-serif", 18))
            .margin(12)
            .margin_left(names + 16)
            .x_label_area_size(36)
            .build_cartesian_2d(padded(boxes.iter().map(BoxOf::range)), 0.0..boxes.len() as f64)?;
        chart.configure_mesh().disable_y_mesh().y_labels(0).x_desc(&self.axis).light_line_style(WHITE).draw()?;
        for (k, one) in boxes.iter().enumerate() {
            let y = (boxes.len() - k) as f64 - 0.5;
            let colour = COLOURS[k % COLOURS.len()];
            let [low, q25, median, q75, high] = one.quantiles;
            let bar = |points: Vec<(f64, f64)>, width| PathElement::new(points, colour.stroke_width(width));
            let box_ = [(q25, y - 0.28), (q75, y + 0.28)];
            chart.draw_series([Rectangle::new(box_, colour.mix(0.25).filled()), Rectangle::new(box_, colour)])?;
            chart.draw_series([
                bar(vec![(low, y), (q25, y)], 1),
                bar(vec![(q75, y), (high, y)], 1),
                bar(vec![(low, y - 0.12), (low, y + 0.12)], 1),
                bar(vec![(high, y - 0.12), (high, y + 0.12)], 1),
                bar(vec![(median, y - 0.28), (median, y + 0.28)], 3),
            ])?;
            chart.draw_series(one.outliers.iter().map(|x| Circle::new((*x, y), 2, colour.mix(0.5))))?;
            let style = ("sans-serif", 14).into_text_style(area).pos(Pos::new(HPos::Right, VPos::Center));
            let (left, middle) = chart.backend_coord(&(chart.x_range().start, y));
            area.draw(&Text::new(one.name.clone(), (left - 8, middle), style))?;
        }
        Ok(())
    }

    fn draw_curves<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        x: &str,
        series: &[(String, Vec<(f64, f64)>)],
    ) -> Result<(), Box<dyn StdError>>
    where
        DB::ErrorType: 'static,
    {
        let along = |axis: fn(&(f64, f64)) -> f64| {
            series.iter().flat_map(move |(_, points)| points.iter().map(move |p| axis(p)..axis(p)))
        };
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, ("sans-serif", 18))
            .margin(12)
            .x_label_area_size(40)
            .y_label_area_size(64)
            .build_cartesian_2d(padded(along(|p| p.0)), padded(along(|p| p.1)))?;
        chart.configure_mesh().x_desc(x).y_desc(&self.axis).light_line_style(WHITE).draw()?;
        for (k, (name, points)) in series.iter().enumerate() {
            let colour = COLOURS[k % COLOURS.len()];
            let line = chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(2)))?;
            if !name.is_empty() {
                line.label(name).legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
            }
            chart.draw_series(points.iter().map(|p| Circle::new(*p, 2, colour.filled())))?;
        }
        if series.iter().any(|(name, _)| !name.is_empty()) {
            let mut labels = chart.configure_series_labels();
            labels.background_style(WHITE.mix(0.8)).border_style(BLACK.mix(0.3)).draw()?;
        }
        Ok(())
    }
}

/// A range around all of these, wide enough that ticks can be distinguished.
fn padded(ranges: impl Iterator<Item = Range<f64>>) -> Range<f64> {
    let (low, high) = ranges
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), range| (low.min(range.start), high.max(range.end)));
    let pad = if high > low { 0.04 * (high - low) } else { 0.5_f64.max(0.1 * low.abs()) };
    let pad = pad.max(NARROWEST_DRAWN * low.abs().max(high.abs()).max(1.0));
    low - pad..high + pad
}
