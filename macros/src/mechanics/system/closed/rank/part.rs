//! Rows that have nothing to do with others.

/// Rows that share coordinates with each other, and with no other rows.
pub struct Part {
    pub rows: Vec<usize>,
    /// For each coordinate, whether one of them has a slope along it in a few states.
    pub held: Vec<bool>,
}

impl Part {
    /// The parts of rows, each with the coordinates that it depends on.
    pub fn all(rows: Vec<Vec<bool>>) -> Vec<Self> {
        let mut parts: Vec<Self> = Vec::new();
        for (number, held) in rows.into_iter().enumerate() {
            let mut whole = Self {
                rows: vec![number],
                held,
            };
            let (joined, apart) = parts.into_iter().partition(|part| part.shares(&whole));
            parts = apart;
            for part in joined {
                whole.join(part);
            }
            parts.push(whole);
        }
        parts
    }

    fn shares(&self, other: &Self) -> bool {
        self.held.iter().zip(&other.held).any(|(a, b)| *a && *b)
    }

    fn join(&mut self, other: Self) {
        self.rows.extend(other.rows);
        for (is_held, also) in self.held.iter_mut().zip(other.held) {
            *is_held |= also;
        }
    }

    pub fn count(&self, found: &[bool]) -> usize {
        self.rows.iter().filter(|row| found[**row]).count()
    }
}
