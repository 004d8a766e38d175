//! Scene, photon tracing, photon map, quantisation, the f64 reference, images.
