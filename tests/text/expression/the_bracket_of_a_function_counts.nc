O1 (EXP-6: SIN and four brackets are five levels)
#100=ABS[[[[[-1]]]]] (expect #100=1)
#101=ABS[[[[[[-1]]]]]] (expect alarm PS0118)
M30
