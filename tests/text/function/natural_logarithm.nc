O1 (section 4.2: and LN[0] raises PS0119)
#100=LN[10] (expect #100=2.30258509)
#101=LN[0] (expect alarm PS0119)
M30
