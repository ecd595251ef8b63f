(run with: --set #11001=100)
O1 (CYC-19: machine Z is R + 100)
G90 G00 Z50.
G43 H1 G99 G81 X0 Y0 Z-10. R2. F100
#100=#5023 (expect #100=102)
#101=#5003 (expect #101=2)
G80
M30
