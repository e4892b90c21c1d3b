/* The kinds of batch transforms, for the kernels and for the host that launches them. */
#ifndef MORPHCL_TRANSFORM_KIND_H
#define MORPHCL_TRANSFORM_KIND_H

#define TRANSFORM_AFFINE 0     /* three rows a matrix */
#define TRANSFORM_PROJECTIVE 1 /* four rows a matrix, division by the fourth coordinate */
#define TRANSFORM_NORMALS 2    /* three rows a matrix, results of length 1 */

#endif
