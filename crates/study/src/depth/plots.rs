//! Curves over depth.

use catoptric_report::{Plot, Report, Scale, Series};

use super::row::Row;

/// Adds time and time per ray against depth.
pub(super) fn add(report: &mut Report, scene: &str, rows: &[Row]) {
    let who = |row: &Row| (row.way.name(), row.threads);
    // A curve for each way and number of threads.
    let curves = |value: fn(&Row) -> Option<f64>| {
        let mut ways: Vec<_> = rows.iter().map(who).collect();
        ways.sort_unstable();
        ways.dedup();
        let curve = |(name, threads)| {
            let of_way = rows.iter().filter(|row| who(row) == (name, threads));
            let points = of_way.filter_map(|row| Some((f64::from(row.depth), value(row)?)));
            let plural = if threads == 1 { "" } else { "s" };
            let name = format!("{name}, {threads} thread{plural}");
            Series { name, points: points.collect(), dashed: false }
        };
        ways.into_iter().rev().map(curve).collect()
    };
    // The same rows twice: the time of a picture, and of a ray.
    report.plot(Plot {
        name: format!("depth-{scene}-time"),
        title: format!("{scene}: time of tracing against depth"),
        caption: "Minimum of the runs. Where a curve is flat, no ray goes deeper.".to_owned(),
        x: "max_depth".to_owned(),
        y: "ms".to_owned(),
        x_scale: Scale::Doublings,
        y_scale: Scale::Log,
        series: curves(|row| row.times.min_ms()),
    });
    report.plot(Plot {
        name: format!("depth-{scene}-ray"),
        title: format!("{scene}: time a ray against depth"),
        caption: "Rays of all kinds. A rise means that deep rays cost more than eye rays."
            .to_owned(),
        x: "max_depth".to_owned(),
        y: "ns a ray".to_owned(),
        x_scale: Scale::Doublings,
        y_scale: Scale::Log,
        series: curves(Row::ns_per_ray),
    });
}
