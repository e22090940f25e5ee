//! A status packet into a `RobotStatus` that is used again: the keys in their usual order, or in any other.
//!
//! Checked are the syntax of all that is read, each value's type, that no key comes twice, and the end.

mod parts;

use jaka_proto::messages::status::RobotStatus;

use self::parts::{bits, floats, inputs, ints, known};
use super::scan::Scan;

/// Reads `packet` into `status`; `None` if it has a key that is not known, or a value in another form than usual.
pub fn read(packet: &str, status: &mut RobotStatus) -> Option<()> {
    let mut scan = Scan::new(packet);
    let mut seen = 0_u64;
    scan.blank();
    scan.need(b"{")?;
    loop {
        let before = seen;
        if turn(&mut scan, status, &mut seen)? {
            scan.end()?;
            return clear_absent(status, seen);
        }
        // Not one key was known.
        if seen == before {
            return None;
        }
    }
}

/// Each key with its number and its place, and how its value is read: the numbers tell which have been seen.
macro_rules! keys {
    ($($number:literal $key:literal $field:ident $read:expr;)*) => {
        /// Goes once through the usual order; true at the packet's end.
        fn turn(scan: &mut Scan<'_>, status: &mut RobotStatus, seen: &mut u64) -> Option<bool> {
            $(
                if scan.eat($key) {
                    scan.blank();
                    if *seen >> $number & 1 == 1 {
                        return None;
                    }
                    *seen |= 1 << $number;
                    $read(&mut *scan, &mut status.$field)?;
                    if !scan.comma(b'}')? {
                        return Some(true);
                    }
                }
            )*
            Some(false)
        }

        fn clear_absent(status: &mut RobotStatus, seen: u64) -> Option<()> {
            $(
                if seen >> $number & 1 == 0 {
                    status.$field = None;
                }
            )*
            Some(())
        }
    };
}

keys! {
    0 br#""len":"# length int;
    1 br#""drag_status":"# drag_status truth;
    2 br#""extio":"# extio |scan, slot| known(slot, parts::extio, scan);
    3 br#""errcode":"# error_code text;
    4 br#""errmsg":"# error_message text;
    5 br#""monitor_data":"# monitor_data |scan, slot| known(slot, parts::monitor, scan);
    6 br#""torqsensor":"# torque_sensor |scan, slot| known(slot, parts::torque_sensor, scan);
    7 br#""joint_actual_position":"# joint_actual_position six;
    8 br#""actual_position":"# actual_position six;
    9 br#""din":"# digital_inputs |scan, slot: &mut Option<_>| bits(scan, slot.get_or_insert_default());
    10 br#""dout":"# digital_outputs |scan, slot: &mut Option<_>| bits(scan, slot.get_or_insert_default());
    11 br#""ain":"# analog_inputs |scan, slot: &mut Option<_>| floats(scan, slot.get_or_insert_default());
    12 br#""aout":"# analog_outputs |scan, slot: &mut Option<_>| floats(scan, slot.get_or_insert_default());
    13 br#""tio_din":"# tool_digital_inputs |scan, slot: &mut Option<_>| bits(scan, slot.get_or_insert_default());
    14 br#""tio_dout":"# tool_digital_outputs |scan, slot: &mut Option<_>| bits(scan, slot.get_or_insert_default());
    15 br#""tio_ain":"# tool_analog_inputs |scan, slot: &mut Option<_>| floats(scan, slot.get_or_insert_default());
    16 br#""task_state":"# task_state int;
    17 br#""homed":"# homed |scan, slot| known(slot, bits, scan);
    18 br#""task_mode":"# task_mode int;
    19 br#""interp_state":"# interpreter_state int;
    20 br#""enabled":"# enabled truth;
    21 br#""paused":"# paused truth;
    22 br#""rapidrate":"# rapid_rate float;
    23 br#""current_tool_id":"# current_tool_id int;
    24 br#""current_user_id":"# current_user_frame_id int;
    25 br#""on_soft_limit":"# on_soft_limit int;
    26 br#""emergency_stop":"# emergency_stop bit;
    27 br#""drag_near_limit":"# drag_near_limit |scan, slot| known(slot, ints, scan);
    28 br#""funcdi":"# function_inputs |scan, slot| known(slot, inputs, scan);
    29 br#""powered_on":"# powered_on bit;
    30 br#""inpos":"# in_position truth;
    31 br#""motion_mode":"# motion_mode int;
    32 br#""curr_tcp_trans_vel":"# tcp_speed float;
    33 br#""protective_stop":"# protective_stop bit;
    34 br#""point_key":"# point_key int;
    35 br#""netState":"# network_state int;
    36 br#""joint_position":"# joint_commanded_position six;
    37 br#""position":"# commanded_position six;
    38 br#""tio_key":"# tool_keys |scan, slot| known(slot, ints, scan);
    39 br#""instVel":"# joint_velocities |scan, slot| known(slot, floats, scan);
    40 br#""relay_io":"# relay_outputs |scan, slot| known(slot, bits, scan);
    41 br#""mb_slave_din":"# modbus_slave_digital_inputs |scan, slot| known(slot, bits, scan);
    42 br#""mb_slave_dout":"# modbus_slave_digital_outputs |scan, slot| known(slot, bits, scan);
    43 br#""mb_slave_ain":"# modbus_slave_analog_inputs |scan, slot| known(slot, floats, scan);
    44 br#""mb_slave_aout":"# modbus_slave_analog_outputs |scan, slot| known(slot, floats, scan);
    45 br#""pn_dev_din":"# profinet_device_digital_inputs |scan, slot| known(slot, bits, scan);
    46 br#""pn_dev_dout":"# profinet_device_digital_outputs |scan, slot| known(slot, bits, scan);
    47 br#""pn_dev_ain":"# profinet_device_analog_inputs |scan, slot| known(slot, floats, scan);
    48 br#""pn_dev_aout":"# profinet_device_analog_outputs |scan, slot| known(slot, floats, scan);
    49 br#""eip_adpt_din":"# ethernet_ip_adapter_digital_inputs |scan, slot| known(slot, bits, scan);
    50 br#""eip_adpt_dout":"# ethernet_ip_adapter_digital_outputs |scan, slot| known(slot, bits, scan);
    51 br#""eip_adpt_ain":"# ethernet_ip_adapter_analog_inputs |scan, slot| known(slot, floats, scan);
    52 br#""eip_adpt_aout":"# ethernet_ip_adapter_analog_outputs |scan, slot| known(slot, floats, scan);
    53 br#""tio_rs_signals":"# tool_rs_signals |scan, slot| known(slot, parts::signals, scan);
    54 br#""motion_line":"# motion_line |scan, slot| known(slot, parts::int, scan);
    55 br#""err_add_line":"# error_add_line |scan, slot| known(slot, parts::int, scan);
}

fn int<T: From<i64>>(scan: &mut Scan<'_>, slot: &mut Option<T>) -> Option<()> {
    *slot = Some(scan.int()?.into());
    Some(())
}

fn float(scan: &mut Scan<'_>, slot: &mut Option<f64>) -> Option<()> {
    *slot = Some(scan.float()?);
    Some(())
}

fn truth(scan: &mut Scan<'_>, slot: &mut Option<bool>) -> Option<()> {
    *slot = Some(scan.truth()?);
    Some(())
}

fn bit(scan: &mut Scan<'_>, slot: &mut Option<bool>) -> Option<()> {
    *slot = Some(scan.bit()?);
    Some(())
}

fn six<T: From<[f64; 6]>>(scan: &mut Scan<'_>, slot: &mut Option<T>) -> Option<()> {
    *slot = Some(scan.array::<f64, 6>(Scan::float)?.into());
    Some(())
}

fn text(scan: &mut Scan<'_>, slot: &mut Option<String>) -> Option<()> {
    scan.text_into(slot.get_or_insert_default())
}
