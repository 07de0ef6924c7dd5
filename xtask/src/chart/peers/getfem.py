"""Pin benchmark with GetFEM: augmented Lagrangian, by ray tracing (large sliding) or projection (small sliding).

usage: getfem.py JOB RESULT. JOB and RESULT are JSON files; lengths in mm, forces in N, stresses in MPa. RESULT holds the
plate's nodal displacements at the end of each converged load step, the iterations, and wall and processor time without
imports.
"""
import json
import sys
import time

import getfem as gf
import numpy as np

job = json.load(open(sys.argv[1]))
start, start_cpu = time.time(), time.process_time()
order = job["order"]
# GetFEM numbers the nodes of a cell row by row.
rows = [0, 1, 3, 2] if order == 1 else [0, 4, 1, 7, 5, 3, 6, 2]
geometry = gf.GeoTrans("GT_QK(2,1)" if order == 1 else "GT_Q2_INCOMPLETE(2)")
element = gf.Fem("FEM_QK(2,1)" if order == 1 else "FEM_Q2_INCOMPLETE(2)")
rule = gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)" % (4 if order == 1 else 6))
CONTACT, SYMMETRY, PULLED = 1, 2, 3


def discretise(body):
    """Mesh with its regions, displacement space and integration method of a body."""
    points = np.array(body["points"])
    mesh = gf.Mesh("empty", 2)
    mesh.add_convex(geometry, np.transpose(points[np.array(body["cells"])[:, rows]], (2, 1, 0)))
    outer = mesh.outer_faces()
    for region, nodes in ((CONTACT, body["contact"]), (SYMMETRY, body["symmetry"]), (PULLED, body["pulled"])):
        if nodes:
            faces = mesh.faces_from_pid(mesh.pid_from_coords(points[nodes].T))
            on_boundary = [face for face in faces.T if (outer.T == face).all(axis=1).any()]
            mesh.set_region(region, np.array(on_boundary).T)
    space = gf.MeshFem(mesh, 2)
    space.set_fem(element)
    return mesh, space, gf.MeshIm(mesh, rule)


plate, pin = job["plate"], job["pin"]
plate_mesh, plate_space, plate_rule = discretise(plate)
pin_mesh, pin_space, pin_rule = discretise(pin)

young, nu = job["young"], job["poisson"]
model = gf.Model("real")
model.add_initialized_data("lame", young * nu / (1 - nu**2))  # plane stress
model.add_initialized_data("shear", young / 2 / (1 + nu))
model.add_initialized_data("traction", [0.0, 0.0])
for name, space, integration in (("u1", plate_space, plate_rule), ("u2", pin_space, pin_rule)):
    model.add_fem_variable(name, space)
    model.add_isotropic_linearized_elasticity_brick(integration, name, "lame", "shear")
    model.add_normal_Dirichlet_condition_with_multipliers(integration, name, order, SYMMETRY)
model.add_initialized_data("centre", np.array(pin["points"])[pin["centre"]].reshape(2, 1))
model.add_initialized_data("along", np.array([[1.0], [0.0]]))
model.add_pointwise_constraints_with_multipliers("u2", "centre", "along")
model.add_source_term_brick(plate_rule, "u1", "traction", PULLED)

mu = job["mu"]
tracing = job["contact"] == "ray tracing"
multipliers = gf.MeshFem(plate_mesh, 2 if tracing or mu > 0 else 1)
multipliers.set_fem(element)
model.add_filtered_fem_variable("contact", multipliers, CONTACT)
# 10 E per inch. Where r is much larger, quadrature points inside the contact of coarse facets open, and pressure is lost.
model.add_initialized_data("r", 15 * young / job["length"])
friction = []
if mu > 0:
    model.add_initialized_data("mu", mu)
    model.add_initialized_fem_data("w1", plate_space, np.zeros(plate_space.nbdof()))
    model.add_initialized_fem_data("w2", pin_space, np.zeros(pin_space.nbdof()))
    friction = ["mu"]
if tracing:
    brick = model.add_integral_large_sliding_contact_brick_raytracing("r", job["release"], *friction)
    model.add_slave_contact_boundary_to_large_sliding_contact_brick(
        brick, plate_rule, CONTACT, "u1", "contact", *(["w1"] if mu > 0 else []))
    model.add_master_contact_boundary_to_large_sliding_contact_brick(
        brick, pin_rule, CONTACT, "u2", *(["w2"] if mu > 0 else []))
else:
    if mu > 0:
        model.add_initialized_data("alpha", 1.0)
    model.add_integral_contact_between_nonmatching_meshes_brick(
        plate_rule, "u1", "u2", "contact", "r", *friction, CONTACT, CONTACT, 1, *(["alpha", "w1", "w2"] if mu > 0 else []))

# A first overlap, so that the first iteration sees contact; the plate is pulled along -x.
guess = np.zeros(plate_space.nbdof())
guess[0::2] = -1e-6 * job["length"]
model.set_variable("u1", guess)

# The degrees of freedom of each node: both lists hold the same points in different orders.
where = plate_space.basic_dof_nodes()[:, ::2].T
points = np.array(plate["points"])
key = lambda p: (round(p[0] * 1e7), round(p[1] * 1e7))
of_point = {key(p): k for k, p in enumerate(where)}
dof = np.array([of_point[key(p)] for p in points])

steps, iterations = [], 0
for traction in job["tractions"]:
    model.set_variable("traction", [-traction, 0.0])
    done, converged = np.ravel(model.solve(
        "max_res", 1e-11, "max_iter", 60, "lsearch", "simplest", "alpha min", 0.2, "lsolver", "mumps"))[:2]
    if not converged:
        break
    iterations += int(done)
    steps.append(model.variable("u1").reshape(-1, 2)[dof].tolist())
    if mu > 0:
        model.set_variable("w1", model.variable("u1"))
        model.set_variable("w2", model.variable("u2"))
report = {"steps": steps, "iterations": iterations, "wall": time.time() - start, "cpu": time.process_time() - start_cpu}
json.dump(report, open(sys.argv[2], "w"))
