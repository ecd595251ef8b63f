gosub sub
print v ' (expect warning LW0001 at v)
end
sub: local v
v=5
return
' (finally prints 0)
