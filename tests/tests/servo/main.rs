//! Tests of set-points: sessions, streams, trajectories and their landings.

mod braking_delay;
mod causes;
mod follow;
mod generator;
mod handles;
mod held_stops;
mod held_up;
mod landing;
mod landing_links;
mod late;
mod options;
mod packet_news;
#[cfg(target_os = "linux")]
mod realtime;
mod received;
mod session;
mod simulated_time;
mod stalls;
mod stop_lengths;
mod stop_matrix;
mod stream;
mod stream_soak;
mod trajectories;
mod under_way;
