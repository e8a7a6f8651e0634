//! Error against work: observed orders, costs, extrapolation, where errors come from, and the stored
//! record.

mod cost;
mod gci;
mod orders;
mod record;
mod split;

use super::Case;
pub(in crate::cases) use orders::whole_ladder;

/// The cases of this folder.
pub const CASES: &[Case] = &[
    Case {
        id: "precision.orders",
        title: "Observed orders of convergence between those that were expected",
        equations: EVERY,
        run: orders::checks,
    },
    Case {
        id: "precision.cost",
        title: "Work grows as the square of the number of elements; what the flags save",
        equations: EVERY,
        run: cost::checks,
    },
    Case {
        id: "precision.gci",
        title: "Richardson's extrapolation and the grid convergence index, where the answer is known and where not",
        equations: EVERY,
        run: gci::checks,
    },
    Case {
        id: "precision.split",
        title: "Rounding, discretisation and model, each by itself",
        equations: EVERY,
        run: split::checks,
    },
    Case {
        id: "precision.record",
        title: "The stored record of error against work is what the code gives",
        equations: EVERY,
        run: record::checks,
    },
];

/// What `verify --full` runs beside all others: it takes minutes.
pub const WHOLE_RECORD: Case = Case {
    id: "precision.whole-record",
    title: "The whole of the stored record of error against work is what the code gives",
    equations: EVERY,
    run: record::whole,
};

const EVERY: &[u8] = &[2, 4, 5, 6, 7, 9, 10, 11, 12, 13, 15, 16, 17, 18, 20];
