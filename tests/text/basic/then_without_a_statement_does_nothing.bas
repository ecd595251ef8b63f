if 1 then
if 0 then else print "else"
' (finally prints else)
