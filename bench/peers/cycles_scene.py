"""The scenes A to E for Cycles, run inside Blender 3.4:

    blender -b --factory-startup -P cycles_scene.py -- SCENE RAYS SEED NOISE OUT.exr

One thread, direct light only (C: one glossy bounce), no denoiser; NOISE above 0 switches adaptive sampling on. Lights
fall off with the square of the distance, and spheres are meshes of smooth faces: Cycles has no others. Prints the time
of the render call, `RENDER_SECONDS wall cpu`."""

import math
import sys
import time

import bmesh
import bpy
import numpy as np

scene_name, rays, seed, noise, picture = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def material(colour, glossy=0.0):
    made = bpy.data.materials.new("material")
    made.use_nodes = True
    nodes, link = made.node_tree.nodes, made.node_tree.links.new
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*colour, 1)
    if not glossy:
        link(diffuse.outputs[0], output.inputs[0])
        return made
    lobe = nodes.new("ShaderNodeBsdfGlossy")
    lobe.inputs["Roughness"].default_value = 0.2
    mixed = nodes.new("ShaderNodeMixShader")
    mixed.inputs[0].default_value = glossy
    link(diffuse.outputs[0], mixed.inputs[1])
    link(lobe.outputs[0], mixed.inputs[2])
    link(mixed.outputs[0], output.inputs[0])
    return made


def place(data, position=(0, 0, 0)):
    placed = bpy.data.objects.new("object", data)
    placed.location = position
    scene.collection.objects.link(placed)
    return placed


def mesh(vertices, faces, surface):
    made = bpy.data.meshes.new("mesh")
    made.from_pydata(vertices, [], faces)
    made.materials.append(surface)
    made.update()
    return made


def sphere(radius, surface):
    made = bpy.data.meshes.new("sphere")
    shape = bmesh.new()
    bmesh.ops.create_uvsphere(shape, u_segments=96, v_segments=48, radius=radius)
    for face in shape.faces:
        face.smooth = True
    shape.to_mesh(made)
    made.materials.append(surface)
    return made


def move(placed, shift):
    """Moves in a straight line from this frame to the next, with the shutter open all that time."""
    placed.keyframe_insert("location", frame=1)
    placed.location = [a + b for a, b in zip(placed.location, shift)]
    placed.keyframe_insert("location", frame=2)
    for curve in placed.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    scene.render.use_motion_blur = True
    scene.render.motion_blur_shutter = 1
    scene.cycles.motion_blur_position = "START"
    scene.frame_set(1)


def light(kind, position, watts, **settings):
    made = bpy.data.lights.new("light", kind)
    made.energy = watts
    for name, value in settings.items():
        setattr(made, name, value)
    return place(made, position)


def build():
    height = -2 if scene_name == "B" else -1
    corners = [(-40, height, 10), (40, height, 10), (40, height, -60), (-40, height, -60)]
    place(mesh(corners, [(0, 1, 2), (0, 2, 3)], material((0.63, 0.63, 0.63))))
    surface = material((0.64, 0.24, 0.16), glossy=0.4 if scene_name == "C" else 0)
    if scene_name == "B":
        shared = sphere(0.5, surface)
        for row in range(1, 21):
            place(shared, (-1.5, -1.5, -row))
            place(shared, (1.5, -1.5, -row))
    elif scene_name == "E":
        arrays = np.load("bumpy_sphere.npz")
        place(mesh(arrays["vertices"].tolist(), arrays["faces"].tolist(), surface))
    else:
        ball = place(sphere(1, surface), (0, 0, -4))
        if scene_name == "D":
            move(ball, (0.5, 0.3, 0))

    light("AREA", (2, 5, -4), 450, shape="DISK", size=1.8).rotation_euler = (-math.pi / 2, 0, 0)
    light("POINT", (-5, 5, 5), 420, shadow_soft_size=0)
    world = scene.world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.2, 0.4, 0.8, 1)
    world.cycles_visibility.diffuse = False  # seen, but no light
    world.cycles.sampling_method = "NONE"

    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "HORIZONTAL"
    camera.angle = math.radians(60)
    if scene_name == "B":
        camera.dof.use_dof = True
        camera.dof.focus_distance = 3
        camera.dof.aperture_fstop = camera.lens * 1e-3 / (2 * 0.08)  # a lens of radius 0.08
    scene.camera = place(camera)


def set_up():
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x = render.resolution_y = 300
    render.threads_mode = "FIXED"
    render.threads = 1
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    cycles.device = "CPU"
    cycles.samples = int(rays)
    cycles.seed = int(seed)
    cycles.use_adaptive_sampling = float(noise) > 0
    cycles.adaptive_threshold = float(noise)
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.diffuse_bounces = cycles.transmission_bounces = 0
    cycles.max_bounces = cycles.glossy_bounces = 1 if scene_name == "C" else 0
    cycles.caustics_reflective = scene_name == "C"


build()
set_up()
start = time.perf_counter(), time.process_time()
bpy.ops.render.render()
print("RENDER_SECONDS", time.perf_counter() - start[0], time.process_time() - start[1])
bpy.data.images["Render Result"].save_render(picture)
