O1 (the tool stays: what is left of the transformation gives the point its new coordinates)
G90 G00 X0 Y0
G51 X0 Y0 P2000
G68 X0 Y0 R90.
G00 X10. Y0 (expect moves: rapid X0 Y20)
G69
#100=#5001 (expect #100=0)
#101=#5002 (expect #101=10)
G91 X5. (expect moves: rapid X10 Y20)
G90 G50
#102=#5001 (expect #102=10)
#103=#5002 (expect #103=20)
M30
