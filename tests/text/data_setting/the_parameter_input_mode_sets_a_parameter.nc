O1 (section 7.4: G10 L50 to G11, here the code that calls O9010)
G10 L50
N6050 R12
G11
G12 A1.
M30
O9010
#100=#1 (expect #100=1)
M99
