O1 (G68, TRF-1: machine 0,10 for program 10,0)
G68 X0 Y0 R90.
G90 G00 X10. Y0 (expect moves: rapid X0 Y10)
#100=#5041 (expect #100=0)
#101=#5042 (expect #101=10)
#102=#5001 (expect #102=10)
#103=#5002 (expect #103=0)
G69
M30
