/**
 * Serves a live session over OpenIGTLink, so that 3D Slicer and other programs can show it.
 *
 * <p>Uses {@code geometry}; it knows no session. Its threads only read what a session publishes, so
 * a slow or hostile client costs the haptic thread nothing. Positions in messages are patient
 * coordinates in mm: right, anterior, superior (RAS).
 */
package org.palpate.igtl;
