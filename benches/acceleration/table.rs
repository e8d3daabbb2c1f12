//! The table, printed and as comma-separated values.

use std::fmt::{self, Write as _};

use crate::paired::Paired;

/// The measured rows.
#[derive(Default)]
pub struct Table {
    pub rows: Vec<Row>,
}

/// A row: two things that do the same.
pub struct Row {
    pub what: String,
    pub times: Paired,
    /// The ratio of times that is to be reached.
    pub reach: Option<f64>,
    pub traffic: Option<Traffic>,
}

/// What is moved between processor and memory.
#[derive(Clone, Copy)]
pub struct Traffic {
    /// The bytes per body: ours, and the other's.
    pub bytes: [usize; 2],
    /// Bytes per ns, measured with a loop that only moves as many bytes as ours.
    pub bandwidth: f64,
}

impl Table {
    pub fn row(&mut self, what: String, times: Paired, reach: Option<f64>) {
        self.rows.push(Row {
            what,
            times,
            reach,
            traffic: None,
        });
    }

    pub fn row_with_traffic(
        &mut self,
        what: String,
        times: Paired,
        reach: Option<f64>,
        traffic: Traffic,
    ) {
        self.row(what, times, reach);
        self.rows.last_mut().expect("the row just made").traffic = Some(traffic);
    }

    /// A line of names, followed by one line for each row. Values that a row does not have are
    /// empty.
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "what,ours_ns,against_ns,ratio,quartile_low,quartile_high,reach,\
             ours_bytes,against_bytes,ours_gb_s,against_gb_s,triad_gb_s\n",
        );
        for row in &self.rows {
            row.write_csv(&mut text).expect("a string takes all");
        }
        text
    }
}

impl Row {
    /// Whether the required ratio is reached.
    pub fn is_reached(&self) -> Option<bool> {
        self.reach.map(|reach| self.times.ratio[1] <= reach)
    }

    fn write_csv(&self, text: &mut String) -> fmt::Result {
        let Paired {
            ours,
            against,
            ratio: [low, ratio, high],
        } = self.times;
        write!(
            text,
            "\"{}\",{ours:.3},{against:.3},{ratio:.4},{low:.4},{high:.4},",
            self.what
        )?;
        if let Some(reach) = self.reach {
            write!(text, "{reach}")?;
        }
        if let Some(([first, second], [ours, against, triad])) = self.speeds() {
            writeln!(text, ",{first},{second},{ours:.2},{against:.2},{triad:.2}")
        } else {
            writeln!(text, ",,,,,")
        }
    }

    fn fmt_times(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Paired {
            ours,
            against,
            ratio: [low, ratio, high],
        } = self.times;
        write!(
            f,
            "{:<56}{ours:>9.2}{against:>9.2}{ratio:>8.3}   {low:.3} to {high:.3}",
            self.what
        )?;
        if let Some(reach) = self.reach {
            write!(f, "{reach:>7.2}")?;
        }
        if self.is_reached() == Some(false) {
            write!(f, "  not reached")?;
        }
        writeln!(f)
    }

    fn fmt_traffic(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(([first, second], [ours, against, triad])) = self.speeds() else {
            return Ok(());
        };
        writeln!(
            f,
            "{:<56}{first:>9}{second:>9}{ours:>8.1}{against:>9.1}{triad:>9.1}",
            self.what
        )
    }

    /// The bytes per body, and the bytes per ns: ours, the other's and those of the triad.
    fn speeds(&self) -> Option<([usize; 2], [f64; 3])> {
        let Traffic { bytes, bandwidth } = self.traffic?;
        let [first, second] =
            bytes.map(|bytes| f64::from(u32::try_from(bytes).expect("few bytes")));
        let speeds = [
            first / self.times.ours,
            second / self.times.against,
            bandwidth,
        ];
        Some((bytes, speeds))
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "ns for one evaluation, medians of 101 rounds in which both are timed; ratio: median of those of the rounds\n\n\
             {:<56}{:>9}{:>9}{:>8}{:>16}{:>7}",
            "what", "ours", "against", "ratio", "quartiles", "reach"
        )?;
        for row in &self.rows {
            row.fmt_times(f)?;
        }
        if self.rows.iter().any(|row| row.traffic.is_some()) {
            writeln!(
                f,
                "\nGB/s, of the bytes of one body that cross between memory and processor; \
                 triad: a = b + 3 c over as many bytes\n\n\
                 {:<56}{:>9}{:>9}{:>8}{:>9}{:>9}",
                "what", "bytes", "against", "GB/s", "against", "triad"
            )?;
        }
        for row in &self.rows {
            row.fmt_traffic(f)?;
        }
        Ok(())
    }
}
