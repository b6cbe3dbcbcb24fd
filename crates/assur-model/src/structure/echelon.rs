//! Sparse elimination over the prime field.

use super::field::Number;

/// A row: columns in falling order, each once, with coefficients other than zero.
pub type Row = Vec<(usize, Number)>;

/// Puts the terms of a row in order and adds up those of one column.
pub fn row(mut terms: Vec<(usize, Number)>) -> Row {
    terms.sort_by_key(|t| std::cmp::Reverse(t.0));
    terms.dedup_by(|next, last| {
        let same = next.0 == last.0;
        if same {
            last.1 += next.1;
        }
        same
    });
    terms.retain(|t| !t.1.is_zero());
    terms
}

/// Rows in echelon form: each begins in a column of its own, the highest in which it has a coefficient.
pub struct Echelon {
    pivots: Vec<Option<Row>>,
    rank: usize,
}

impl Echelon {
    #[must_use]
    pub fn new(columns: usize) -> Self {
        Self { pivots: vec![None; columns], rank: 0 }
    }

    pub fn of<'a>(columns: usize, rows: impl IntoIterator<Item = &'a Row>) -> Self {
        let mut echelon = Self::new(columns);
        for row in rows {
            echelon.add(row.clone());
        }
        echelon
    }

    /// Number of independent rows.
    #[must_use]
    pub const fn rank(&self) -> usize {
        self.rank
    }

    /// Adds a row. `false` where it depends on those before it.
    pub fn add(&mut self, mut row: Row) -> bool {
        while let Some(&(column, x)) = row.first() {
            let Some(pivot) = &self.pivots[column] else {
                self.pivots[column] = Some(row);
                self.rank += 1;
                return true;
            };
            row = less(&row, pivot, x);
        }
        false
    }

    /// Whether no row begins in this column.
    pub fn is_free(&self, column: usize) -> bool {
        self.pivots[column].is_none()
    }

    /// The vector that all rows take to zero and that has these values in the free columns.
    pub fn null_vector(&self, free: impl Fn(usize) -> Number) -> Vec<Number> {
        let mut x = vec![Number::ZERO; self.pivots.len()];
        for (column, pivot) in self.pivots.iter().enumerate() {
            x[column] = match pivot {
                None => free(column),
                Some(row) => {
                    let sum = row[1..].iter().fold(Number::ZERO, |sum, t| sum + t.1 * x[t.0]);
                    -sum * row[0].1.inverse()
                }
            };
        }
        x
    }
}

/// `p·row − x·pivot`, where the pivot begins with `p`, and the row with `x` in the same column: no inverse is needed.
fn less(row: &Row, pivot: &Row, x: Number) -> Row {
    let p = pivot[0].1;
    let mut out = Row::with_capacity(row.len() + pivot.len() - 2);
    let (mut a, mut b) = (row[1..].iter().peekable(), pivot[1..].iter().peekable());
    loop {
        let (column, value) = match (a.peek(), b.peek()) {
            (None, None) => return out,
            (Some(&&(i, y)), None) => (i, p * y),
            (None, Some(&&(k, z))) => (k, -(x * z)),
            (Some(&&(i, y)), Some(&&(k, z))) => match i.cmp(&k) {
                std::cmp::Ordering::Greater => (i, p * y),
                std::cmp::Ordering::Less => (k, -(x * z)),
                std::cmp::Ordering::Equal => (i, p * y - x * z),
            },
        };
        a.next_if(|t| t.0 == column);
        b.next_if(|t| t.0 == column);
        if !value.is_zero() {
            out.push((column, value));
        }
    }
}
