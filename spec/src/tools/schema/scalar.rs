//! Scalars.

use serde_json::{Value, json};

use super::lenient;
use super::parts::Form;
use crate::Scalar;

/// A scalar as it is sent, or in any form in which it is read.
pub(super) fn schema(scalar: &Scalar, form: Form) -> Value {
    match (scalar, form) {
        (Scalar::Bool { off, on }, Form::Sent) if off == "false" && on == "true" => json!({ "type": "boolean" }),
        (Scalar::Bool { off, on }, Form::Sent) => json!({ "enum": [parsed(off), parsed(on)] }),
        (Scalar::Bool { off, on }, Form::Received) => lenient::boolean([off, on]),
        (Scalar::Int, Form::Sent) => json!({ "type": "integer" }),
        (Scalar::Int, Form::Received) => lenient::integer(),
        (Scalar::Float, Form::Sent) => json!({ "type": "number" }),
        (Scalar::Float, Form::Received) => lenient::number(),
        (Scalar::Text, _) => json!({ "type": "string" }),
        (Scalar::Json, _) => json!({}),
    }
}

/// The value of a JSON text of the spec.
fn parsed(json: &str) -> Value {
    serde_json::from_str(json).unwrap_or_else(|_| json!(json))
}
