//! A plot as SVG.
//!
//! Lines and letters take the colour of the text around them, so that one drawing serves a
//! light page and a dark one.

use std::sync::Arc;

use kuva::backend::svg::SvgBackend;
use kuva::plot::LinePlot;
use kuva::plot::legend::LegendPosition;
use kuva::plot::scatter::{MarkerShape, ScatterPlot};
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot as Layer;
use kuva::render::render::render_multiple;
use kuva::render::theme::Theme;

use crate::escape::escaped;
use crate::plot::{Plot, Scale, Series};

/// Colours that people with any vision tell apart (Okabe and Ito, Color Universal Design,
/// 2008; its yellow and black left out, which a white or a dark page swallows), and marks
/// for those who print without colour.
const STYLES: [(&str, MarkerShape); 8] = [
    ("#0072b2", MarkerShape::Circle),
    ("#d55e00", MarkerShape::Square),
    ("#009e73", MarkerShape::Triangle),
    ("#cc79a7", MarkerShape::Diamond),
    ("#e69f00", MarkerShape::TriangleDown),
    ("#56b4e9", MarkerShape::Plus),
    ("#8c8c8c", MarkerShape::Cross),
    ("#8c564b", MarkerShape::Circle),
];

/// Units of the drawing, which are pixels unless it is scaled.
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 420.0;

/// Below this kuva's logarithmic axes end (0.6); a linear axis of logarithms goes on.
const SMALLEST: f64 = 1e-10;

/// The drawing, for a page that states its colours.
///
/// # Panics
/// If it has more curves than there are colours.
#[must_use]
pub(crate) fn drawing(plot: &Plot) -> String {
    assert!(plot.series.len() <= STYLES.len(), "{}: too many curves for one plot", plot.name);
    let mut drawable: Vec<_> = plot.series.iter().map(|series| points(plot, series)).collect();
    let tiny = plot.y_scale == Scale::Log && drawable.iter().flatten().any(|(_, y)| *y < SMALLEST);
    // The library knows neither doublings nor numbers this small: move them to where it is linear.
    if plot.x_scale == Scale::Doublings {
        for (x, _) in drawable.iter_mut().flatten() {
            *x = (*x + 1.0).log2();
        }
    }
    if tiny {
        for (_, y) in drawable.iter_mut().flatten() {
            *y = y.log10();
        }
    }
    // Curves without points are left out, but the others keep their colours.
    let along = |axis: fn(&(f64, f64)) -> f64| drawable.iter().flatten().map(axis).collect();
    let (xs, ys): (Vec<f64>, Vec<f64>) = (along(|p| p.0), along(|p| p.1));
    let layers: Vec<Layer> = plot
        .series
        .iter()
        .zip(drawable)
        .zip(STYLES)
        .filter(|((_, points), _)| !points.is_empty())
        .flat_map(|((series, points), style)| layers(series, points, style))
        .collect();
    if layers.is_empty() {
        return empty(plot);
    }
    // Lay out the axes, and label them with the numbers before they were moved.
    let mut layout = Layout::auto_from_plots(&layers)
        .with_theme(theme())
        .with_title(plot.title.as_str())
        .with_x_label(plot.x.as_str())
        .with_y_label(plot.y.as_str())
        .with_title_size(15)
        .with_width(WIDTH)
        .with_height(HEIGHT)
        .with_legend_position(LegendPosition::OutsideRightTop);
    match plot.x_scale {
        Scale::Linear => {}
        Scale::Log => layout = layout.with_log_x().with_x_tick_format(number(xs)),
        Scale::Doublings => layout = layout.with_x_tick_step(1.0).with_x_tick_format(doubled()),
    }
    if tiny {
        layout = layout.with_y_tick_step(2.0).with_y_tick_format(power_of_ten());
    } else if plot.y_scale == Scale::Log {
        layout = layout.with_log_y().with_y_tick_format(number(ys));
    }
    let svg = SvgBackend::new().render_scene(&render_multiple(layers, layout));
    // Drawings stand side by side on one page, where names must be the page's only ones.
    svg.replace("kuva-clip-", &format!("{}-clip-", plot.name))
}

/// The drawing as a file of its own, which states its colours itself.
#[must_use]
pub(crate) fn file(plot: &Plot) -> String {
    let style = "<style>svg{color:#1f2328;background:#fff}\
        @media(prefers-color-scheme:dark){svg{color:#e6edf3;background:#0d1117}}</style>";
    drawing(plot).replacen('>', &format!(">{style}"), 1) + "\n"
}

fn layers(series: &Series, points: Vec<(f64, f64)>, style: (&str, MarkerShape)) -> Vec<Layer> {
    let (colour, mark) = style;
    let line =
        LinePlot::new().with_data(points.iter().copied()).with_color(colour).with_stroke_width(2.0);
    if series.dashed {
        return vec![Layer::Line(line.with_dashed().with_legend(series.name.as_str()))];
    }
    // The legend shows the mark, which tells curves apart without their colours.
    let marks = ScatterPlot::new()
        .with_data(points)
        .with_color(colour)
        .with_size(3.5)
        .with_marker(mark)
        .with_legend(series.name.as_str());
    vec![Layer::Line(line), Layer::Scatter(marks)]
}

/// The points that its axes can show.
fn points(plot: &Plot, series: &Series) -> Vec<(f64, f64)> {
    let shows = |scale: Scale, x: f64| {
        x.is_finite()
            && match scale {
                Scale::Linear => true,
                Scale::Log => x > 0.0,
                Scale::Doublings => x >= 0.0,
            }
    };
    let all = series.points.iter().copied();
    all.filter(|&(x, y)| shows(plot.x_scale, x) && shows(plot.y_scale, y)).collect()
}

/// Nothing was measured that the axes could show.
fn empty(plot: &Plot) -> String {
    let title = escaped(&plot.title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"60\" \
         font-family=\"sans-serif\" fill=\"currentColor\"><text x=\"20\" y=\"35\">{title}: \
         nothing to draw</text></svg>"
    )
}

/// The label of a number: 0.1 and 20 on an axis where no number is long, 1e-1 and 2e1 else.
fn number(values: Vec<f64>) -> TickFormat {
    let short = values.iter().all(|x| (1e-2..1e4).contains(x));
    TickFormat::Custom(Arc::new(move |x| {
        // Ticks are computed, so 3 may be 2.9999999999999996.
        let text = format!("{x:.5e}");
        let x: f64 = text.parse().unwrap_or(x);
        if short { format!("{x}") } else { format!("{x:e}") }
    }))
}

/// The label of log2(x + 1).
fn doubled() -> TickFormat {
    TickFormat::Custom(Arc::new(|logarithm| format!("{}", logarithm.exp2().round() - 1.0)))
}

/// The label of a logarithm.
fn power_of_ten() -> TickFormat {
    TickFormat::Custom(Arc::new(|exponent| format!("1e{exponent:.0}")))
}

fn theme() -> Theme {
    let text = || "currentColor".to_owned();
    let none = || "none".to_owned();
    Theme {
        background: none(),
        axis_color: text(),
        tick_color: text(),
        text_color: text(),
        grid_color: "#80808040".to_owned(),
        legend_bg: none(),
        legend_border: none(),
        ..Theme::light()
    }
}
