O1 (section 11.5: M01 does nothing)
M01
#100=1 (expect #100=1)
M30
