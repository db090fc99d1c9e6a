//! Every format of a report, and what it says of its occasion.

mod occasion;
mod report;
