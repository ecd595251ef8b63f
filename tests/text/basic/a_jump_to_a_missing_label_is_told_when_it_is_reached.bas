if 0 then 999
if 0 then 999 else print "on"
if 1 then print "here" else 999
if 1 then 999 else print "bad" ' (expect alarm LB0006 at 999)
' (finally prints on)
' (finally prints here)
