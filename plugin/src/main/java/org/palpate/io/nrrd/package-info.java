/**
 * Reads NRRD, attached or detached, with 3D Slicer's segment names, and writes its header.
 *
 * <p>Uses {@code io.codec}, {@code io.format}, {@code io.volume} and {@code io.file}. An instance
 * is for one thread. World axes are those that the header names, in millimetres.
 */
package org.palpate.io.nrrd;
