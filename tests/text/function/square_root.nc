O1 (section 4.2: and a negative argument raises PS0119)
#100=SQRT[3*3+4*4] (expect #100=5)
#101=SQRT[-1] (expect alarm PS0119)
M30
(finally #100=5, #101=null)
