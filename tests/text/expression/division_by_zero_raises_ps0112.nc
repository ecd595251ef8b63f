O1 (EXP-8: whatever the dividend)
#100=#101/0 (expect alarm PS0112)
M30
(finally #100=null)
