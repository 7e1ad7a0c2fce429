//! Geometry for drawing a scene.

use cdpr_core::geometry::{Polytope, Vector};
use serde_json::{Value, json};

fn faces(body: &Polytope) -> Value {
    let vertices: Vec<[f64; 3]> = body.vertices().iter().map(|&v| v.into()).collect();
    json!({ "vertices": vertices, "faces": body.facets().iter().map(|f| &f.corners).collect::<Vec<_>>() })
}

/// Bodies and cables of a scene as JSON.
pub fn drawn(scene: &cdpr_core::Scene) -> String {
    let turned = |part: &Polytope| part.transformed(scene.orientation(), &Vector::zeros());
    let cables = scene.robot().cables();
    json!({
        "obstacles": scene.obstacles().iter().map(|o| json!({
            "name": o.name,
            "parts": o.parts.iter().map(faces).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "platform": scene.robot().parts().iter().map(|part| faces(&turned(part))).collect::<Vec<_>>(),
        "cables": cables.iter().zip(scene.envelopes()).map(|(cable, envelope)| json!({
            "name": cable.name,
            "outlet": <[f64; 3]>::from(cable.outlet),
            "attachment": <[f64; 3]>::from(scene.orientation() * cable.attachment),
            "bent": cdpr_view::bent(cable, envelope.as_deref()),
        })).collect::<Vec<_>>(),
    })
    .to_string()
}
