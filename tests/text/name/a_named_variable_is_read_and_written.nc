O1 (section 7.2: SETVN names #500)
SETVN500[ABC]
[#ABC]=4
#100=#500 (expect #100=4)
#101=[#ABC]*2 (expect #101=8)
M30
