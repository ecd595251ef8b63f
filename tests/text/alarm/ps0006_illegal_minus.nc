O1 (PS0006: a negative spindle speed)
M03 S-100 (expect alarm PS0006 at S-100)
M30
