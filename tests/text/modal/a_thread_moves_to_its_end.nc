O1 (section 8.1: G33 has the geometry of G01)
S500 M03
G90 G33 Z-10. F2.
#100=#4001 (expect #100=33)
M30
(finally machine X0 Y0 Z-10)
