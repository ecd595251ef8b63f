O1 (MFZ: results below 1e-8 become 0)
#1=SIN[0.0000001]
IF[#1EQ0]THEN #100=1 (expect #100=1)
M30
