/**
 * Checks a hand-built device against the HID protocol of {@code native/docs/hid-protocol.md}.
 *
 * <p>Depends on the JDK alone. Any thread; nothing here runs in a frame. Units stand in the names.
 * {@code ProtocolCheckTest} compares the numbers of the protocol with the example firmware.
 */
package org.palpate.device.protocol;
