//! The nested parts of a status packet.

use jaka_proto::messages::beyond_io::{ToolSignal, literal as beyond_literal};
use jaka_proto::messages::io::literal as io_literal;
use jaka_proto::messages::io::{ExtioPinRange, ExtioRtu, ExtioTcp, FunctionInput};
use jaka_proto::messages::status::literal as status_literal;
use jaka_proto::messages::status::{
    ExtioPinStates, ExtioReport, ExtioReportPinMap, ExtioReportPins, ExtioReportSetup, JointMonitor, MonitorData,
    TorqueSensorPayload, TorqueSensorReport, TorqueSensorSettings, TorqueSensorState, TorqueSensorTcp,
};
use jaka_proto::wire::{Typed, Value};

use crate::limit::scan::Scan;

/// A part that can be read into what it was before.
pub(super) trait Blank {
    /// Something to begin with.
    fn blank() -> Self;
}

/// Reads a part of a known shape into its slot.
pub(super) fn known<'a, T: Blank>(
    slot: &mut Option<Typed<T>>,
    read: impl Fn(&mut Scan<'a>, &mut T) -> Option<()>,
    scan: &mut Scan<'a>,
) -> Option<()> {
    let slot = slot.get_or_insert_with(|| Typed::Known(T::blank()));
    if let Typed::Raw(_) = slot {
        *slot = Typed::Known(T::blank());
    }
    match slot {
        Typed::Known(value) => read(scan, value),
        Typed::Raw(_) => None,
    }
}

pub(super) fn bits(scan: &mut Scan<'_>, into: &mut Vec<bool>) -> Option<()> {
    scan.bits(into)
}

pub(super) fn floats(scan: &mut Scan<'_>, into: &mut Vec<f64>) -> Option<()> {
    scan.list(into, Scan::float)
}

pub(super) fn ints(scan: &mut Scan<'_>, into: &mut Vec<i64>) -> Option<()> {
    scan.list(into, Scan::int)
}

pub(super) fn int(scan: &mut Scan<'_>, into: &mut i64) -> Option<()> {
    *into = scan.int()?;
    Some(())
}

pub(super) fn inputs(scan: &mut Scan<'_>, into: &mut Vec<FunctionInput>) -> Option<()> {
    scan.list(into, |scan| {
        let [kind, index] = scan.array::<i64, 2>(Scan::int)?;
        Some(FunctionInput::from(io_literal::FunctionInput { kind: kind.into(), index }))
    })
}

pub(super) fn monitor(scan: &mut Scan<'_>, into: &mut MonitorData) -> Option<()> {
    scan.need(b"[")?;
    into.scb_major_version = first(scan, Scan::int)?;
    into.scb_minor_version = first(scan, Scan::int)?;
    into.cabinet_temperature = first(scan, Scan::float)?;
    into.bus_average_power = first(scan, Scan::float)?;
    into.bus_average_current = first(scan, Scan::float)?;
    scan.list(&mut into.joints, joint)?;
    let mut more = scan.comma(b']')?;
    for tail in [&mut into.seventh, &mut into.eighth, &mut into.ninth] {
        *tail = None;
        if more {
            *tail = Some(Typed::Known(scan.int()?));
            more = scan.comma(b']')?;
        }
    }
    into.bus_voltage = None;
    if more {
        into.bus_voltage = Some(scan.float()?);
        more = scan.comma(b']')?;
    }
    (!more).then_some(())
}

pub(super) fn signals(scan: &mut Scan<'_>, into: &mut Vec<ToolSignal>) -> Option<()> {
    scan.list(into, |scan| {
        let mut name = String::new();
        scan.need(b"[")?;
        scan.text_into(&mut name)?;
        scan.comma(b']')?.then_some(())?;
        let signal = ToolSignal::from(beyond_literal::ToolSignal {
            name,
            channel: first(scan, Scan::int)?,
            signal_type: first(scan, Scan::int)?,
            address: first(scan, Scan::int)?,
            value: first(scan, Scan::int)?,
            frequency: scan.float()?,
        });
        last(scan)?;
        Some(signal)
    })
}

fn joint(scan: &mut Scan<'_>) -> Option<JointMonitor> {
    scan.need(b"[")?;
    let mut joint = JointMonitor::from(status_literal::JointMonitor {
        current: first(scan, Scan::float)?,
        voltage: first(scan, Scan::float)?,
        temperature: first(scan, Scan::float)?,
        average_power: first(scan, Scan::float)?,
        current_fluctuation: first(scan, Scan::float)?,
        total_revolutions: first(scan, Scan::float)?,
        total_running_time: first(scan, Scan::float)?,
        cycles_since_start: first(scan, Scan::float)?,
        running_time_since_start: first(scan, Scan::float)?,
        torque: scan.float()?,
        model_torque: None,
    });
    if scan.comma(b']')? {
        joint.model_torque = Some(scan.float()?);
        last(scan)?;
    }
    Some(joint)
}

/// An element with another after it.
fn first<'a, T>(scan: &mut Scan<'a>, one: impl Fn(&mut Scan<'a>) -> Option<T>) -> Option<T> {
    let value = one(scan)?;
    scan.comma(b']')?.then_some(value)
}

/// The end of an array.
fn last(scan: &mut Scan<'_>) -> Option<()> {
    (!scan.comma(b']')?).then_some(())
}

pub(super) fn torque_sensor(scan: &mut Scan<'_>, into: &mut TorqueSensorReport) -> Option<()> {
    scan.need(b"[")?;
    scan.need(b"[0,")?;
    let TorqueSensorSettings::Tcp { connection, payload, .. } = &mut into.settings else { return None };
    scan.need(b"[")?;
    scan.text_into(&mut connection.address)?;
    scan.comma(b']')?.then_some(())?;
    connection.port = scan.int()?;
    last(scan)?;
    scan.comma(b']')?.then_some(())?;
    scan.need(b"[")?;
    let mass = first(scan, Scan::float)?;
    *payload = Typed::Known(TorqueSensorPayload::from(status_literal::TorqueSensorPayload {
        mass,
        centroid: scan.array::<f64, 3>(Scan::float)?.into(),
    }));
    last(scan)?;
    last(scan)?;
    scan.comma(b']')?.then_some(())?;
    scan.need(b"[")?;
    into.state.working = first(scan, Scan::bit)?;
    into.state.error_code = Typed::Known(first(scan, Scan::int)?);
    into.state.contact_force = first(scan, |scan| scan.array::<f64, 6>(Scan::float))?;
    into.state.raw_reading = scan.array::<f64, 6>(Scan::float)?;
    into.state.unconditional_contact_force = None;
    if scan.comma(b']')? {
        into.state.unconditional_contact_force = Some(Typed::Known(scan.array::<f64, 6>(Scan::float)?));
        last(scan)?;
    }
    last(scan)
}

pub(super) fn extio(scan: &mut Scan<'_>, into: &mut ExtioReport) -> Option<()> {
    scan.need(b"{")?;
    // This object always has the same keys in the same order.
    scan.need(br#""status":"#)?;
    pin_states(scan, &mut into.pin_states)?;
    next(scan)?;
    scan.need(br#""setup":"#)?;
    setups(scan, &mut into.setup)?;
    next(scan)?;
    scan.need(br#""num":"#)?;
    into.count = scan.int()?;
    next(scan)?;
    scan.need(br#""pinmap":"#)?;
    scan.list(&mut into.pin_maps, pin_map)?;
    next(scan)?;
    scan.need(br#""mode":"#)?;
    into.mode = scan.int()?;
    (!scan.comma(b'}')?).then_some(())
}

fn next(scan: &mut Scan<'_>) -> Option<()> {
    scan.comma(b'}')?.then_some(())
}

fn pin_states(scan: &mut Scan<'_>, into: &mut ExtioPinStates) -> Option<()> {
    scan.need(b"[")?;
    bits(scan, &mut into.digital_inputs)?;
    scan.comma(b']')?.then_some(())?;
    bits(scan, &mut into.digital_outputs)?;
    scan.comma(b']')?.then_some(())?;
    floats(scan, &mut into.analog_inputs)?;
    scan.comma(b']')?.then_some(())?;
    floats(scan, &mut into.analog_outputs)?;
    last(scan)
}

fn pin_map(scan: &mut Scan<'_>) -> Option<ExtioReportPinMap> {
    let [digital_inputs, digital_outputs, analog_inputs, analog_outputs] = scan.array::<i64, 4>(Scan::int)?;
    Some(ExtioReportPinMap::from(status_literal::ExtioReportPinMap {
        digital_inputs,
        digital_outputs,
        analog_inputs,
        analog_outputs,
    }))
}

/// The modules, in place of those before.
fn setups(scan: &mut Scan<'_>, into: &mut Vec<ExtioReportSetup>) -> Option<()> {
    scan.need(b"[")?;
    let mut len = 0;
    while !(len == 0 && scan.eat(b"]")) {
        if into.len() == len {
            into.push(ExtioReportSetup::Other(Value::Null));
        }
        setup(scan, &mut into[len])?;
        len += 1;
        if !scan.comma(b']')? {
            break;
        }
    }
    into.truncate(len);
    Some(())
}

fn setup(scan: &mut Scan<'_>, into: &mut ExtioReportSetup) -> Option<()> {
    scan.need(b"[")?;
    match first(scan, Scan::int)? {
        0 => rtu(scan, into),
        1 => tcp(scan, into),
        _ => None,
    }
}

fn rtu(scan: &mut Scan<'_>, into: &mut ExtioReportSetup) -> Option<()> {
    if !matches!(into, ExtioReportSetup::Rtu { connection: Typed::Known(_), .. }) {
        let connection = ExtioRtu::from(io_literal::ExtioRtu {
            baud_rate: 0,
            data_bit_length: 0,
            slave_id: 0,
            data_bits: 0,
            parity: Value::Null,
            stop_bit_length: 0,
        });
        *into = ExtioReportSetup::from(status_literal::ExtioReportSetup::Rtu {
            name: String::new(),
            connection: Typed::Known(connection),
            pins: no_pins(),
            fifth: None,
        });
    }
    let ExtioReportSetup::Rtu { name, connection: Typed::Known(connection), pins, fifth, .. } = into else {
        return None;
    };
    scan.text_into(name)?;
    scan.comma(b']')?.then_some(())?;
    scan.need(b"[")?;
    connection.baud_rate = first(scan, Scan::int)?;
    connection.data_bit_length = first(scan, Scan::int)?;
    connection.slave_id = first(scan, Scan::int)?;
    connection.data_bits = first(scan, Scan::int)?;
    scan.json_into(&mut connection.parity)?;
    scan.comma(b']')?.then_some(())?;
    connection.stop_bit_length = scan.int()?;
    last(scan)?;
    scan.comma(b']')?.then_some(())?;
    *pins = pin_ranges(scan)?;
    fifth_of_setup(scan, fifth)
}

fn tcp(scan: &mut Scan<'_>, into: &mut ExtioReportSetup) -> Option<()> {
    if !matches!(into, ExtioReportSetup::Tcp { .. }) {
        let connection = ExtioTcp::from(io_literal::ExtioTcp { address: String::new(), port: 0, slave_id: None });
        *into = ExtioReportSetup::from(status_literal::ExtioReportSetup::Tcp {
            name: String::new(),
            connection,
            pins: no_pins(),
            fifth: None,
        });
    }
    let ExtioReportSetup::Tcp { name, connection, pins, fifth, .. } = into else { return None };
    scan.text_into(name)?;
    scan.comma(b']')?.then_some(())?;
    scan.need(b"[")?;
    scan.text_into(&mut connection.address)?;
    scan.comma(b']')?.then_some(())?;
    connection.port = scan.int()?;
    connection.slave_id = None;
    if scan.comma(b']')? {
        connection.slave_id = Some(scan.int()?);
        last(scan)?;
    }
    scan.comma(b']')?.then_some(())?;
    *pins = pin_ranges(scan)?;
    fifth_of_setup(scan, fifth)
}

fn fifth_of_setup(scan: &mut Scan<'_>, into: &mut Option<Typed<String>>) -> Option<()> {
    if !scan.comma(b']')? {
        *into = None;
        return Some(());
    }
    if !matches!(into, Some(Typed::Known(_))) {
        *into = Some(Typed::Known(String::new()));
    }
    let Some(Typed::Known(text)) = into else { return None };
    scan.text_into(text)?;
    last(scan)
}

fn no_pins() -> ExtioReportPins {
    let none = ExtioPinRange::from(io_literal::ExtioPinRange { start: 0, count: 0 });
    let (digital_inputs, digital_outputs, analog_inputs, analog_outputs) = (none, none, none, none);
    ExtioReportPins::from(status_literal::ExtioReportPins {
        digital_inputs,
        digital_outputs,
        analog_inputs,
        analog_outputs,
    })
}

fn pin_ranges(scan: &mut Scan<'_>) -> Option<ExtioReportPins> {
    let range = |scan: &mut Scan<'_>| {
        let [start, count] = scan.array::<i64, 2>(Scan::int)?;
        Some(ExtioPinRange::from(io_literal::ExtioPinRange { start, count }))
    };
    scan.need(b"[")?;
    let pins = ExtioReportPins::from(status_literal::ExtioReportPins {
        digital_inputs: first(scan, range)?,
        digital_outputs: first(scan, range)?,
        analog_inputs: first(scan, range)?,
        analog_outputs: range(scan)?,
    });
    last(scan)?;
    Some(pins)
}

impl<T> Blank for Vec<T> {
    fn blank() -> Self {
        Self::new()
    }
}

impl Blank for i64 {
    fn blank() -> Self {
        0
    }
}

impl Blank for MonitorData {
    fn blank() -> Self {
        Self::from(status_literal::MonitorData {
            scb_major_version: 0,
            scb_minor_version: 0,
            cabinet_temperature: 0.0,
            bus_average_power: 0.0,
            bus_average_current: 0.0,
            joints: Vec::new(),
            seventh: None,
            eighth: None,
            ninth: None,
            bus_voltage: None,
        })
    }
}

impl Blank for TorqueSensorReport {
    fn blank() -> Self {
        let connection = TorqueSensorTcp::from(status_literal::TorqueSensorTcp { address: String::new(), port: 0 });
        Self::from(status_literal::TorqueSensorReport {
            settings: TorqueSensorSettings::from(status_literal::TorqueSensorSettings::Tcp {
                connection,
                payload: Typed::Raw(Value::Null),
            }),
            state: TorqueSensorState::from(status_literal::TorqueSensorState {
                working: false,
                error_code: Typed::Known(0),
                contact_force: [0.0; 6],
                raw_reading: [0.0; 6],
                unconditional_contact_force: None,
            }),
        })
    }
}

impl Blank for ExtioReport {
    fn blank() -> Self {
        let pin_states = ExtioPinStates::from(status_literal::ExtioPinStates {
            digital_inputs: Vec::new(),
            digital_outputs: Vec::new(),
            analog_inputs: Vec::new(),
            analog_outputs: Vec::new(),
        });
        let (setup, pin_maps) = (Vec::new(), Vec::new());
        Self::from(status_literal::ExtioReport { pin_states, setup, count: 0, pin_maps, mode: 0 })
    }
}
