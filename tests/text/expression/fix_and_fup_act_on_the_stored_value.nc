O1 (EXP-11: no tidying up before the cut)
#100=FIX[[0.1+0.7]*10] (expect #100=7)
#101=FUP[[0.1+0.2]*10] (expect #101=4)
M30
