(run with: --param 6051=100)
O1 (section 6.4: 6050 to 6059 are O9010 to O9019)
G100 A3.
M30
O9011
#100=#1 (expect #100=3)
M99
