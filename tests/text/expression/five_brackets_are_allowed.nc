O1 (EXP-6: and the sixth raises PS0118)
#100=[[[[[1]]]]] (expect #100=1)
#101=[[[[[[1]]]]]] (expect alarm PS0118)
M30
(finally #100=1, #101=null)
