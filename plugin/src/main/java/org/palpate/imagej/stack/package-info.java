/**
 * The stack that is touched: its voxels, geometry, segments and grey values, and the transfer of
 * changed pixels to the running session.
 *
 * <p>Uses {@code host}, {@code edit} and {@code io}. The stack belongs to ImageJ; one thread
 * transfers its changes. Grid coordinates; spacing in millimetres.
 */
package org.palpate.imagej.stack;
