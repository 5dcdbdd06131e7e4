/**
 * Elastic bodies: the deformation that maps material coordinates to present ones, its proof, its
 * updates, and the contact of an interaction point that lives in material coordinates.
 *
 * <p>Uses {@code elastic.lattice}, {@code proxy}, {@code sync} and what stands below them. The
 * haptic thread owns {@code ElasticContact} and what it holds; one other thread owns {@code
 * FieldUpdater}. {@code FieldExchange}, {@code ElasticLoad.Exchange} and {@code ChangedCells} stand
 * between them and never wait. Positions are grid coordinates, forces newtons along the axes of the
 * grid.
 */
package org.palpate.elastic;
